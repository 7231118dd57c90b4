package org.pendant.script.vm;

import java.util.Optional;
import org.pendant.script.value.Value;

/**
 * Named value: a variable as it is at the moment.
 *
 * @param value the variable's own, to be read in this frame only; empty before it was assigned
 */
public record NamedValue(String name, Optional<Value> value) {}
