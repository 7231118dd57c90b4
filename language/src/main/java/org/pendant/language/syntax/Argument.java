package org.pendant.language.syntax;

import java.util.Optional;
import org.pendant.language.source.SourceRange;

/** One argument of a call, {@code value} or {@code name = value}. */
public record Argument(Optional<String> name, Expression value, SourceRange range)
    implements Node {}
