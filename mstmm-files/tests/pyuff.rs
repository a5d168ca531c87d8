//! Written universal files as another program reads them: `pyuff`, where Python has it.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod support;

use mstmm_files::{write_uff15, write_uff55, write_uff82};
use std::process::Command;
use support::{MODEL, complex_mode, exact, file, mast};

/// What a script prints about a file, if Python has `pyuff`.
fn read(name: &str, script: &str, file: &[u8]) -> Option<serde_json::Value> {
    let has_pyuff = Command::new("python3").args(["-c", "import pyuff"]).output().is_ok_and(|run| run.status.success());
    if !has_pyuff {
        // past the capture of the test harness, so that nobody takes it for a success
        use std::io::Write;
        let _ = writeln!(std::io::stderr(), "skipped: python3 has no pyuff, which would read the file");
        return None;
    }
    let path = std::env::temp_dir().join(format!("mstmm-files-{name}-{}.uff", std::process::id()));
    std::fs::write(&path, file).unwrap();
    let run = Command::new("python3").args(["-c", script]).arg(&path).output().unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    Some(serde_json::from_slice(&run.stdout).unwrap())
}

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
    // two datasets in one file
    let Some(sets) = read("responses", SCRIPT, file().repeat(2).as_bytes()) else { return };
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

/// Reads the file of shapes and prints what it holds as JSON.
const SHAPES: &str = "
import json, sys, pyuff
file = pyuff.UFF(sys.argv[1])
sets = [file.read_sets(k) for k in range(file.get_n_sets())]
nodes, traces, modes = [[one for one in sets if one['type'] == kind] for kind in (15, 82, 55)]
parts = lambda values: [[complex(value).real, complex(value).imag] for value in values]
print(json.dumps({
    'node_nums': list(nodes[0]['node_nums']), 'places': [list(nodes[0][axis]) for axis in 'xyz'],
    'traces': [[trace['id'].strip(), trace['trace_num'], trace['n_nodes'], list(trace['nodes'])] for trace in traces],
    'modes': [{'texts': [mode['id1'].strip(), mode['id2'].strip()], 'kind': mode['analysis_type'], 'n': mode['mode_n'],
               'node_nums': [int(node) for node in mode['node_nums']], 'r2': parts(mode['r2']),
               'freq': mode.get('freq'), 'mass': mode.get('modal_m'),
               'eig': parts([mode.get('eig', 0)])[0], 'a': parts([mode.get('modal_a', 0)])[0]} for mode in modes]}))
";

#[test]
fn another_program_reads_shapes() {
    let (lines, modes) = mast::modes(3);
    let (_, complex) = complex_mode();
    let mut file = Vec::new();
    write_uff15(&mut file, lines.geometry()).unwrap();
    write_uff82(&mut file, lines.geometry()).unwrap();
    write_uff55(&mut file, "a mast", lines.geometry(), modes).unwrap();
    write_uff55(&mut file, "an oscillator", &complex_mode().0, [complex]).unwrap();
    let Some(read) = read("shapes", SHAPES, &file) else { return };
    let numbers = |value: &serde_json::Value| {
        value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(numbers(&read["node_nums"]), (1..=40).map(f64::from).collect::<Vec<_>>());
    assert_eq!(numbers(&read["places"][2])[19..], [mast::HEIGHT; 21]);
    assert_eq!(read["traces"][1][0], "member 1");
    assert_eq!(numbers(&read["traces"][1][3]), (21..=40).map(f64::from).collect::<Vec<_>>());
    let first = &read["modes"][0];
    assert_eq!(first["texts"][0], "a mast");
    assert_eq!((first["kind"].as_i64(), first["n"].as_i64(), first["mass"].as_f64()), (Some(2), Some(1), Some(1.0)));
    assert!((first["freq"].as_f64().unwrap() / mast::first_hertz() - 1.0).abs() < 1e-5);
    let tip = first["r2"][19][0].as_f64().unwrap();
    assert!((tip.abs() - mast::first_shape(mast::HEIGHT)).abs() < 1e-6);
    assert_eq!((read["modes"].as_array().unwrap().len(), read["modes"][3]["kind"].as_i64()), (4, Some(3)));
    let [lambda, a, shape] =
        [&read["modes"][3]["eig"], &read["modes"][3]["a"], &read["modes"][3]["r2"][1]].map(|pair| {
            let pair = numbers(pair);
            mstmm::Complex::new(pair[0], pair[1])
        });
    assert!((lambda - mstmm::Complex::new(-1.0, 399.0_f64.sqrt())).norm() < 1e-4);
    let residue = mstmm::Complex::new(0.0, 2.0 * MODEL.m * 399.0_f64.sqrt()).inv();
    assert!((shape * shape / a - residue).norm() < 5e-5 * residue.norm());
}
