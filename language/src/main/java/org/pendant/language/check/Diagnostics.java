package org.pendant.language.check;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.SourceRange;

/** Diagnostics collected so far. */
final class Diagnostics {
  private final List<Diagnostic> found = new ArrayList<>();

  void addAll(Collection<Diagnostic> diagnostics) {
    found.addAll(diagnostics);
  }

  void error(String code, SourceRange range, String message) {
    found.add(Diagnostic.error(code, range, message, ""));
  }

  void warning(String code, SourceRange range, String message) {
    found.add(Diagnostic.warning(code, range, message));
  }

  /** An error about {@code name} that the controller words as a name it cannot find. */
  void nameNotFound(String code, String name, SourceRange range, String message) {
    found.add(Diagnostic.error(code, range, message, "compile_error_name_not_found:" + name + ":"));
  }

  /** In the order in which they were found. */
  List<Diagnostic> all() {
    return found;
  }

  List<Diagnostic> sorted() {
    found.sort((a, b) -> Integer.compare(a.range().start(), b.range().start()));
    return List.copyOf(found);
  }
}
