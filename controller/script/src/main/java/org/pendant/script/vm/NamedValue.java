package org.pendant.script.vm;

import java.util.Optional;
import org.pendant.script.value.Value;

/**
 * A variable as it is now.
 *
 * @param value the variable's own, to be read in this frame only; empty before it was assigned
 */
public record NamedValue(String name, Optional<Value> value) {}
