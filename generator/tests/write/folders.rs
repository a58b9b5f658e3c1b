//! Folders: made, named in any way, held by one at a time.

use super::{content, generated, write};
use generator::write::{commit, open, stage};
use std::sync::mpsc;
use std::{fs, thread};

#[test]
fn a_folder_below_folders_is_made_and_stays() {
    let folder = tempfile::tempdir().unwrap();
    write(&folder.path().join("a/../b/c"), &[generated("d/e", "1")], false).unwrap();
    assert!(folder.path().join("b/c/d/e").is_file());
    assert_eq!(content(&folder.path().join("b/c/d")).len(), 1);
}

/// The second waits until the first is done, and then sees what it did.
#[test]
fn a_folder_is_held_by_one_at_a_time() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let first = open(&out).unwrap();
    let staged = stage(&first, &generated("a", "1"));
    let (sender, receiver) = mpsc::channel();
    let second = thread::spawn({
        let out = out.clone();
        move || {
            let held = open(&out).unwrap();
            sender.send(()).unwrap();
            let staged = stage(&held, &generated("a", "1"));
            commit(held, vec![staged], false).unwrap()
        }
    });
    assert!(receiver.try_recv().is_err());
    commit(first, vec![staged], false).unwrap();
    receiver.recv().unwrap();
    assert_eq!(second.join().unwrap().unchanged, 1);
}

/// The run that made a folder fails while another holds it, which is no run into the same folder.
#[test]
fn a_folder_that_another_holds_is_not_taken_away() {
    let folder = tempfile::tempdir().unwrap();
    let above = folder.path().join("a");
    let first = open(&above.join("b")).unwrap();
    let second = open(&above).unwrap();
    drop(first);
    let staged = stage(&second, &generated("c", "1"));
    commit(second, vec![staged], false).unwrap();
    assert_eq!(content(&above).len(), 1);
}

/// Those that had made the folder fail, and take it away, while others wait for it. A run may find it gone before it holds it,
/// make it again, and still takes it away once only: the next time it is another's.
#[test]
fn a_folder_that_vanishes_is_made_again() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    for _ in 0..1000 {
        let writers = [0, 1, 2, 3, 4, 5].map(|number| {
            let out = out.clone();
            thread::spawn(move || {
                let held = open(&out).unwrap();
                if number == 5 {
                    let staged = stage(&held, &generated("a", "1"));
                    commit(held, vec![staged], false).unwrap();
                }
            })
        });
        writers.into_iter().for_each(|writer| writer.join().unwrap());
        assert_eq!(content(&out).len(), 1);
        fs::remove_dir_all(&out).unwrap();
    }
    assert_eq!(content(folder.path()), Vec::<(String, String)>::new());
}
