/**
 * Replay: runs a controller once more, up to any frame: from the same options, with the same
 * commands in the same frames, it comes to the same state bit for bit, and continues from there. A
 * {@link org.pendant.recording.replay.Journal} keeps the commands, a {@link
 * org.pendant.recording.replay.Rerun} makes the other controller. Open Journal first.
 */
package org.pendant.recording.replay;
