package org.pendant.language.service;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.check.Scopes;
import org.pendant.language.service.Occurrence.Role;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.syntax.Script;

/** Symbol index: every name of one program, by place and by meaning. */
final class SymbolIndex {
  private final List<Occurrence> occurrences;
  private final Map<Symbol, Set<String>> members;

  private SymbolIndex(SymbolWalk walk) {
    this.occurrences = walk.found();
    this.members = walk.members();
  }

  static SymbolIndex of(Script script, Scopes scopes, Catalogue catalogue) {
    SymbolWalk walk = new SymbolWalk(scopes, catalogue);
    // Not the program's form: that leaves out a call after the program.
    walk.statements(script.statements(), scopes.mainScope());
    return new SymbolIndex(walk);
  }

  /** All of them, in the order of the text. */
  List<Occurrence> all() {
    return occurrences;
  }

  /** The name that holds {@code offset} or ends there. */
  Optional<Occurrence> at(int offset) {
    int low = 0;
    int high = occurrences.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (occurrences.get(middle).range().start() <= offset) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low > 0 && occurrences.get(low - 1).range().end() >= offset
        ? Optional.of(occurrences.get(low - 1))
        : Optional.empty();
  }

  /** Every occurrence of {@code symbol}, in the order of the text. */
  List<Occurrence> of(Symbol symbol) {
    return occurrences.stream().filter(other -> other.symbol().equals(symbol)).toList();
  }

  /** Where {@code symbol} comes from: its declaration, else its first assignment. */
  Optional<Occurrence> origin(Symbol symbol) {
    List<Occurrence> all = of(symbol);
    return all.stream()
        .filter(other -> other.role() == Role.DECLARE)
        .findFirst()
        .or(() -> all.stream().filter(other -> other.role() == Role.WRITE).findFirst());
  }

  /** The members of the structs that this variable is assigned as literals; else none. */
  Set<String> members(Symbol variable) {
    return members.getOrDefault(variable, Set.of());
  }

  /** The names of all members in the text. */
  List<String> members() {
    return occurrences.stream()
        .filter(other -> other.symbol() instanceof Symbol.Member)
        .map(other -> other.symbol().name())
        .distinct()
        .toList();
  }
}
