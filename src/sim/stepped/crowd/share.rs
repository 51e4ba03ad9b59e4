//! Work on several threads.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

use bevy::tasks::ComputeTaskPool;

/// Balls from which on a light pass is shared: it takes a few nanoseconds a ball, and a thread some ten thousand to wake.
const WORTH: usize = 16_384;

/// Works on all items on so many threads. Each thread begins with the same part of them every time, so that what it works
/// on stays in its own cache, and helps the others when that is done; what is done to an item does not depend on who
/// does it.
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
    let items: Vec<T> = items.collect();
    let (count, mut items) = (items.len(), items.into_iter());
    let part = |thread: usize| count * (thread + 1) / threads - count * thread / threads;
    let parts = (0..threads).map(|thread| items.by_ref().take(part(thread)).collect());
    let parts: Vec<Mutex<VecDeque<T>>> = parts.map(Mutex::new).collect();
    let next = |thread: usize| {
        let lock = |part: usize| parts[part].lock().unwrap_or_else(PoisonError::into_inner);
        let own = lock(thread).pop_front();
        // What another will come to last.
        own.or_else(|| (1..threads).find_map(|k| lock((thread + k) % threads).pop_back()))
    };
    let run = |thread: usize| {
        while let Some(item) = next(thread) {
            work(item);
        }
    };
    let run = &run;
    pool.scope(|scope| {
        for thread in 1..threads {
            scope.spawn(async move { run(thread) });
        }
        run(0);
    });
}

/// So many threads for a light pass over so many balls, or one if it is over before another thread has woken up.
pub(super) fn light(threads: usize, balls: usize) -> usize {
    if balls < WORTH { 1 } else { threads }
}
