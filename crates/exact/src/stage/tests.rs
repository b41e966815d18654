use super::*;

#[test]
fn counters_grow_and_forcing_ends_with_its_guard() {
    {
        let _guard = force(Start::Big);
        assert_eq!(start(), Start::Big);
    }
    let _guard = force(Start::Usual);
    assert_eq!(start(), Start::Usual);
    let (before, all) = (thread_counts(), counts());
    for stage in Stage::ALL {
        count(stage);
    }
    let counted = thread_counts() - before;
    assert_eq!(counted.total(), 5);
    assert!(Stage::ALL.iter().all(|&stage| counted.of(stage) == 1));
    assert!((counts() - all).total() >= 5);
}

#[test]
fn a_failure_under_a_guard_does_not_lock_out_others() {
    let failed = std::thread::spawn(|| {
        let _guard = force(Start::Fixed);
        panic!("as a failing test does");
    });
    assert!(failed.join().is_err());
    let _guard = force(Start::Usual);
    assert_eq!(start(), Start::Usual);
}
