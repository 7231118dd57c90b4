package org.pendant.language.check;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.syntax.Statement.Definition;

/**
 * Check memory: what the last check of a text has said of its definitions. The check of a later
 * version says the same of those whose text is the same, as long as what they may name means the
 * same, too. One memory belongs to all versions of a text; it is for any thread.
 */
public final class CheckMemory {
  private volatile Kept kept = new Kept(new Surroundings(List.of(), Map.of(), Map.of()), Map.of());

  /**
   * What a check has left.
   *
   * @param bodies what was said of definitions
   */
  private record Kept(Surroundings surroundings, Map<Key, CheckedBody> bodies) {}

  /** A definition, by what it says and where its names come from. */
  record Key(String text, boolean inMain) {}

  /**
   * All that what is said of a definition depends on but its own text.
   *
   * @param known values of any kind, compared by equality
   * @param outer the functions around the program, by name
   * @param main those in it
   */
  record Surroundings(List<Object> known, Map<String, String> outer, Map<String, String> main) {
    static Surroundings of(
        Scopes scopes, Survey survey, Catalogue catalogue, ProgramForm.Kind kind) {
      return new Surroundings(
          List.of(
              catalogue,
              kind == ProgramForm.Kind.LIBRARY,
              Set.copyOf(scopes.globals()),
              survey.ofGlobals()),
          heads(scopes.outermost()),
          heads(scopes.mainScope()));
    }

    private static Map<String, String> heads(FunctionScope scope) {
      Map<String, String> heads = new HashMap<>();
      scope.ownFunctions().forEach((name, definition) -> heads.put(name, head(definition)));
      return heads;
    }

    private static String head(Definition definition) {
      return definition.kind() + " " + definition.head();
    }
  }

  /** What was said where everything around was as it is now. */
  Map<Key, CheckedBody> bodies(Surroundings now) {
    Kept last = kept;
    return last.surroundings().equals(now) ? last.bodies() : Map.of();
  }

  void keep(Surroundings now, Map<Key, CheckedBody> bodies) {
    kept = new Kept(now, bodies);
  }
}
