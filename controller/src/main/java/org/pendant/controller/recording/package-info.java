/**
 * Writes what a controller does to a file, one row a frame. Open {@link
 * org.pendant.controller.recording.Recorder} first.
 */
package org.pendant.controller.recording;
