package org.pendant.controller.machine;

import java.util.List;
import java.util.Optional;
import org.pendant.language.source.Diagnostic;

/**
 * What became of a text.
 *
 * @param program present when no diagnostic is an error
 * @param diagnostics errors and warnings in the order of the text
 */
public record Loaded(Optional<Program> program, List<Diagnostic> diagnostics) {
  public Loaded {
    diagnostics = List.copyOf(diagnostics);
  }
}
