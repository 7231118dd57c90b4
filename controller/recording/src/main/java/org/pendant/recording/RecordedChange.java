package org.pendant.recording;

import java.util.Optional;
import org.pendant.script.variables.VariableSample;

/**
 * Recorded change: a moment at which a recording has another value of a variable than before.
 *
 * @param moment the first with the new value
 * @param before empty where the variable did not exist
 * @param after empty where it does not exist any more
 */
public record RecordedChange(
    Moment moment, Optional<VariableSample> before, Optional<VariableSample> after) {}
