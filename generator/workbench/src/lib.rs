//! The commands of axgen for a page in a browser: files and a request in, an answer in JSON and files out. The page is in
//! `page`; its worker calls the functions of this file and nothing else.
//!
//! ```text
//! request   the requests                  session   the files and the set between two requests
//! answer    what each request answers     curves    the loop of an axis as numbers
//! recorded  recordings: measure, tune     zip       files as one archive
//! ```
#![warn(clippy::disallowed_methods)] // the sign of a 0 would depend on the compiler

mod answer;
mod curves;
mod recorded;
mod request;
mod session;
mod zip;

use session::Session;
use std::cell::RefCell;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
#[cfg(target_family = "wasm")]
use wasm_bindgen::prelude::wasm_bindgen;

thread_local! {
    static SESSION: RefCell<Session> = RefCell::default();
}

/// The message of the panic that ended the module.
static PANIC: Mutex<String> = Mutex::new(String::new());

/// Keeps the messages of panics: the page shows them, and begins again with a new worker.
#[cfg_attr(target_family = "wasm", wasm_bindgen)]
pub fn begin() {
    std::panic::set_hook(Box::new(|panic| {
        *PANIC.lock().unwrap_or_else(PoisonError::into_inner) = panic.to_string();
    }));
}

/// The message of the panic; empty if there was none.
#[cfg_attr(target_family = "wasm", wasm_bindgen)]
#[must_use]
pub fn panicked() -> String {
    PANIC.lock().unwrap_or_else(PoisonError::into_inner).clone()
}

/// Adds a file, or replaces it.
#[cfg_attr(target_family = "wasm", wasm_bindgen)]
pub fn put(name: &str, bytes: Vec<u8>) {
    SESSION.with_borrow_mut(|session| session.files.0.insert(PathBuf::from(name), bytes));
}

/// Removes a file.
#[cfg_attr(target_family = "wasm", wasm_bindgen)]
pub fn remove(name: &str) {
    SESSION.with_borrow_mut(|session| session.files.0.remove(&PathBuf::from(name)));
}

/// The content of a file, or of the archive that was made last; empty if there is none.
#[cfg_attr(target_family = "wasm", wasm_bindgen)]
#[must_use]
pub fn get(name: &str) -> Vec<u8> {
    SESSION.with_borrow(|session| match &session.archive {
        Some((archive, bytes)) if archive == name => bytes.clone(),
        Some(_) | None => session.files.0.get(&PathBuf::from(name)).cloned().unwrap_or_default(),
    })
}

/// Answers a request, both in JSON.
#[cfg_attr(target_family = "wasm", wasm_bindgen)]
#[must_use]
pub fn ask(request: &str) -> String {
    SESSION.with_borrow_mut(|session| answer::answer(session, request))
}
