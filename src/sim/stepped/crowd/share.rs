//! Work on several threads.

use std::sync::{Mutex, PoisonError};

use bevy::tasks::ComputeTaskPool;

/// Balls from which on a light pass is shared: it takes a few nanoseconds a ball, and a thread some ten thousand to wake.
const WORTH: usize = 16_384;

/// Works on all items on so many threads. Items are given out one by one, so that no thread waits for another that drew
/// the heavy ones; what is done to an item does not depend on who does it.
pub(super) fn share<T: Send>(
    threads: usize,
    items: impl Iterator<Item = T> + Send,
    work: impl Fn(T) + Sync,
) {
    let pool = ComputeTaskPool::try_get().filter(|_| threads > 1);
    let Some(pool) = pool else {
        items.for_each(work);
        return;
    };
    let (queue, work) = (Mutex::new(items), &work);
    let run = || {
        loop {
            let item = queue.lock().unwrap_or_else(PoisonError::into_inner).next();
            let Some(item) = item else { break };
            work(item);
        }
    };
    pool.scope(|scope| {
        for _ in 1..threads {
            scope.spawn(async { run() });
        }
        run();
    });
}

/// So many threads for a light pass over so many balls, or one if it is over before another thread has woken up.
pub(super) fn light(threads: usize, balls: usize) -> usize {
    if balls < WORTH { 1 } else { threads }
}
