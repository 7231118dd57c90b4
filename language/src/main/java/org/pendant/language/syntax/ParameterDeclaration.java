package org.pendant.language.syntax;

import java.util.Optional;
import org.pendant.language.source.SourceRange;

/** One parameter in a function's head, with its default if it has one. */
public record ParameterDeclaration(
    String name, Optional<Expression> defaultValue, SourceRange range) implements Node {}
