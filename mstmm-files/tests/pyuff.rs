//! A written dataset 58 as another program reads it: `pyuff`, where Python has it.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod support;

use std::process::Command;
use support::{exact, file};

/// Reads the file and prints what it holds as JSON.
const SCRIPT: &str = "
import json, sys, pyuff
file = pyuff.UFF(sys.argv[1])
sets = [file.read_sets(k) for k in range(file.get_n_sets())]
keys = ['type', 'func_type', 'rsp_node', 'rsp_dir', 'ref_node', 'ref_dir', 'id1', 'abscissa_spec_data_type',
        'ordinate_spec_data_type', 'orddenom_spec_data_type', 'abscissa_axis_units_lab']
print(json.dumps([{**{key: one[key] for key in keys},
                   'x': list(one['x']), 're': list(one['data'].real), 'im': list(one['data'].imag)} for one in sets]))
";

#[test]
fn another_program_reads_what_was_written() {
    let has_pyuff = Command::new("python3").args(["-c", "import pyuff"]).output().is_ok_and(|run| run.status.success());
    if !has_pyuff {
        // past the capture of the test harness, so that nobody takes it for a success
        use std::io::Write;
        let _ = writeln!(std::io::stderr(), "skipped: python3 has no pyuff, which would read the file");
        return;
    }
    let path = std::env::temp_dir().join(format!("mstmm-files-{}.uff", std::process::id()));
    // two datasets in one file
    std::fs::write(&path, file().repeat(2)).unwrap();
    let run = Command::new("python3").args(["-c", SCRIPT]).arg(&path).output().unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let sets: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(sets.as_array().unwrap().len(), 2);
    for set in sets.as_array().unwrap() {
        let of = |key: &str| set[key].as_i64();
        assert_eq!((of("type"), of("func_type")), (Some(58), Some(4)));
        assert_eq!((of("rsp_node"), of("rsp_dir")), (Some(12), Some(2)));
        assert_eq!((of("ref_node"), of("ref_dir")), (Some(4_000_000_000), Some(6)));
        let kinds = ["abscissa_spec_data_type", "ordinate_spec_data_type", "orddenom_spec_data_type"].map(of);
        assert_eq!(kinds, [18, 8, 13].map(Some));
        assert_eq!(set["id1"].as_str().unwrap().trim(), "mass on a spring and a dashpot");
        assert_eq!(set["abscissa_axis_units_lab"].as_str().unwrap().trim(), "Hz");
        let numbers = |key: &str| set[key].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect::<Vec<_>>();
        let (hertz, re, im) = (numbers("x"), numbers("re"), numbers("im"));
        assert_eq!(hertz.len(), support::samples().len());
        for (k, (omega, _)) in support::samples().into_iter().enumerate() {
            assert!((hertz[k] * std::f64::consts::TAU - omega).abs() <= 0.6e-7 * omega);
            let expected = exact(omega);
            assert!((expected.re - re[k]).hypot(expected.im - im[k]) < 1e-11 * expected.norm(), "{omega}");
        }
    }
}
