//! The files of a crate: what each imports, and how long it is.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, ImplItemFn, Item, ItemFn, ItemUse, TraitItemFn, UseTree};

/// A file of a crate; tests are no part of it.
pub(crate) struct File {
    /// Path below `src`, without its extension, and of the file of a folder the path of the folder.
    pub(crate) name: String,
    pub(crate) lines: usize,
    pub(crate) functions: Vec<(String, usize)>,
    /// Paths in the code that lead to other modules, from the root of the crate.
    paths: Vec<Vec<String>>,
    /// Names that are handed on, and where they come from.
    handed_on: BTreeMap<String, Vec<String>>,
}

/// The files of a crate.
pub(crate) struct Source {
    pub(crate) name: &'static str,
    pub(crate) files: Vec<File>,
}

impl Source {
    pub(crate) fn of(name: &'static str) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(name).join("src");
        let mut files = Vec::new();
        collect(&root, &root, &mut files);
        assert!(!files.is_empty(), "no sources in {}", root.display());
        Source { name, files }
    }

    /// Other files that a file imports, handing on followed to where a name comes from.
    pub(crate) fn imports(&self, file: &File) -> BTreeSet<String> {
        let found = file.paths.iter().filter_map(|path| self.file_of(path, 0));
        found.filter(|name| *name != file.name && !name.is_empty()).collect()
    }

    fn file_of(&self, path: &[String], depth: usize) -> Option<String> {
        let named = |name: &str| self.files.iter().find(|file| file.name == name);
        let (length, file) =
            (0..=path.len()).rev().find_map(|length| Some((length, named(&path[..length].join("/"))?)))?;
        match path.get(length).and_then(|name| file.handed_on.get(name)) {
            Some(origin) if depth < 8 => self.file_of(origin, depth + 1).or(Some(file.name.clone())),
            _ => Some(file.name.clone()),
        }
    }
}

fn collect(root: &Path, folder: &Path, files: &mut Vec<File>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let inner = path.strip_prefix(root).unwrap().with_extension("");
        if inner.iter().any(|part| part == "tests" || part == "laws") {
            continue;
        }
        if path.is_dir() {
            collect(root, &path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let name = inner.to_str().unwrap().replace('\\', "/");
            let folder = name.strip_suffix("/mod").or(name.strip_suffix("lib").filter(|rest| rest.is_empty()));
            files.push(parse(&path, folder.unwrap_or(&name)));
        }
    }
}

fn parse(path: &Path, name: &str) -> File {
    let text = std::fs::read_to_string(path).unwrap();
    let syntax = syn::parse_file(&text).unwrap();
    let here: Vec<String> = name.split('/').filter(|part| !part.is_empty()).map(str::to_owned).collect();
    let mut reader = Reader { here, paths: Vec::new(), handed_on: BTreeMap::new(), functions: Vec::new() };
    reader.visit_file(&syntax);
    let Reader { paths, handed_on, functions, .. } = reader;
    File { name: name.to_owned(), lines: text.lines().count(), functions, paths, handed_on }
}

struct Reader {
    here: Vec<String>,
    paths: Vec<Vec<String>>,
    handed_on: BTreeMap<String, Vec<String>>,
    functions: Vec<(String, usize)>,
}

impl Reader {
    /// A path from the root of the crate, if it is one of this crate.
    fn absolute(&self, path: &[String]) -> Option<Vec<String>> {
        let rest = |count: usize| path[count..].iter().cloned();
        match path.first()?.as_str() {
            "crate" => Some(rest(1).collect()),
            "self" => Some(self.here.iter().cloned().chain(rest(1)).collect()),
            "super" => {
                let ups = path.iter().take_while(|part| *part == "super").count();
                let above = self.here.len().checked_sub(ups)?;
                Some(self.here[..above].iter().cloned().chain(rest(ups)).collect())
            }
            _ => None,
        }
    }

    fn use_tree(&mut self, tree: &UseTree, before: &[String], is_handed_on: bool) {
        let with = |name: String| [before, &[name]].concat();
        match tree {
            UseTree::Path(path) => self.use_tree(&path.tree, &with(path.ident.to_string()), is_handed_on),
            UseTree::Group(group) => group.items.iter().for_each(|item| self.use_tree(item, before, is_handed_on)),
            UseTree::Name(name) => self.used(&with(name.ident.to_string()), &name.ident.to_string(), is_handed_on),
            UseTree::Rename(name) => self.used(&with(name.ident.to_string()), &name.rename.to_string(), is_handed_on),
            UseTree::Glob(_) => self.used(before, "*", is_handed_on),
        }
    }

    fn used(&mut self, path: &[String], name: &str, is_handed_on: bool) {
        let inside = || self.here.iter().cloned().chain(path.iter().cloned()).collect();
        let absolute = self.absolute(path);
        if is_handed_on {
            self.handed_on.insert(name.to_owned(), absolute.unwrap_or_else(inside));
        } else if let Some(absolute) = absolute {
            self.paths.push(absolute);
        }
    }

    fn function(&mut self, name: &syn::Ident, item: &impl Spanned) {
        let span = item.span();
        self.functions.push((name.to_string(), span.end().line + 1 - span.start().line));
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string().starts_with("test"),
        other => other.path().is_ident("test"),
    })
}

fn attributes_of(item: &Item) -> &[Attribute] {
    match item {
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        _ => &[],
    }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item(&mut self, item: &'ast Item) {
        if !is_test(attributes_of(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        let is_handed_on = !matches!(item.vis, syn::Visibility::Inherited);
        self.use_tree(&item.tree, &[], is_handed_on);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let parts: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if parts.first().is_some_and(|first| first == "crate" || first == "super") {
            self.paths.extend(self.absolute(&parts));
        }
        visit::visit_path(self, path);
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.function(&item.sig.ident, &item.block);
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        self.function(&item.sig.ident, &item.block);
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        self.function(&item.sig.ident, item);
        visit::visit_trait_item_fn(self, item);
    }
}
