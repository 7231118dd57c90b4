/**
 * Recording: what a controller did, kept to be looked at again. Open {@link
 * org.pendant.recording.RecordingRing} first: it takes every frame and holds the last minutes.
 * {@link org.pendant.recording.Recording} is what can be read of it, or of a file.
 *
 * <p>In memory and in files ({@code docs/recording.md}) a recording is a row of segments. Each
 * begins with a whole snapshot and continues with what each frame has changed: numbers in {@link
 * org.pendant.recording.NumberGroup}s, which tend to change in every frame, and {@link
 * org.pendant.recording.SnapshotPart}s, which rarely do.
 *
 * <pre>{@code
 * RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);
 * // after each frame, in the thread that drives the controller
 * ring.take(controller.state());
 *
 * // any thread
 * Recording recording = ring.recording();
 * ControllerState then = recording.at(12.5);
 * ColumnTrace speed = recording.scan(Column.of("tcp_speed", 0), recording.firstS(), recording.lastS(), 800);
 * RecordingExport.toRec(recording, 10, 15, file);
 * Recording again = RecordingFile.open(file).recording();
 * }</pre>
 *
 * {@link org.pendant.recording.Recorder} writes comma-separated values.
 */
package org.pendant.recording;
