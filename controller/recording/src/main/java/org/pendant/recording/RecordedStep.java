package org.pendant.recording;

import java.util.Optional;
import org.pendant.script.debug.DebugState;
import org.pendant.script.variables.VariableSamples;

/**
 * Recorded step: a moment at which the program had come to another statement, as far as a recording
 * knows: it has the line that the main thread has reached at the end of each frame, and all that a
 * debugger stopped before.
 *
 * @param line of that statement, from 1
 * @param stop of a debugger; empty if nothing stopped there
 * @param variables as the recording has them then
 */
public record RecordedStep(
    Moment moment, int line, Optional<DebugState.Stop> stop, VariableSamples variables) {}
