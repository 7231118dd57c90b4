package org.pendant.script.vm;

import java.util.List;
import java.util.Optional;
import org.pendant.language.source.Diagnostic;

/**
 * Result of loading a script.
 *
 * @param program present when no diagnostic is an error
 * @param diagnostics errors and warnings in the order of the text
 */
public record LoadResult(Optional<Program> program, List<Diagnostic> diagnostics) {
  /** The code of the error that a text holds functions and no program. */
  static final String LIBRARY = "library";

  public LoadResult {
    diagnostics = List.copyOf(diagnostics);
  }

  /** That the text is a library, and thus does not run; no mistake in itself. */
  public Optional<Diagnostic> library() {
    return diagnostics.stream().filter(each -> each.code().equals(LIBRARY)).findFirst();
  }

  /** The errors and warnings about what the text says, be it a program or a library. */
  public List<Diagnostic> mistakes() {
    return diagnostics.stream().filter(each -> !each.code().equals(LIBRARY)).toList();
  }
}
