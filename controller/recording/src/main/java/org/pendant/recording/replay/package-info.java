/**
 * Replay: runs a controller, or all of a cell, once more, up to any frame: from the same options,
 * with the same commands in the same frames, they come to the same state bit for bit, and continue
 * from there. A {@link org.pendant.recording.replay.RunJournal} keeps the commands, a {@link
 * org.pendant.recording.replay.Rerun} makes the other controllers. Open RunJournal first.
 */
package org.pendant.recording.replay;
