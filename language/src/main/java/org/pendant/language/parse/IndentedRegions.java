package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.Token;
import org.pendant.language.source.Source;

/**
 * Indented regions: finds the ends that are missing or too many by the indentation of definitions:
 * from one {@code def} to the next, blocks should open and close as their columns say. Where they
 * do not, {@link EndSearch} looks for the place.
 */
final class IndentedRegions {
  private final IndentedLines lines;

  /** Those that open, divide and close blocks, and the end of the text. */
  private final List<ScriptToken> words;

  /** The definitions around the place that is looked at, as their columns say. */
  private final List<ScriptToken> around = new ArrayList<>();

  private final List<Region> unbalanced = new ArrayList<>();

  /**
   * Where blocks do not open and close as they should.
   *
   * @param from index of its first word
   * @param to index after its last word
   * @param around the definitions that it stands in
   * @param left how many of these are open after it
   * @param missing how many ends are missing; negative if there are too many
   */
  record Region(int from, int to, List<ScriptToken> around, int left, int missing) {}

  IndentedRegions(Source source, List<ScriptToken> tokens) {
    lines = new IndentedLines(source, tokens);
    words = tokens.stream().filter(IndentedRegions::isWord).toList();
  }

  private static boolean isWord(ScriptToken token) {
    int type = token.getType();
    return TokenKinds.opensBlock(type) || TokenKinds.endsBlock(type) || type == Token.EOF;
  }

  /** The fault of the text, if it has one only. */
  Optional<BlockFaults> single() {
    int end = words.size() - 1;
    int missing = balance(0, end);
    return Math.abs(missing) == 1
        ? new EndSearch(lines, words, new Region(0, end, List.of(), 0, missing)).fault()
        : Optional.empty();
  }

  /**
   * The faults of the text, where each definition has one at most.
   *
   * @param count how many there are at least
   * @return nothing if indentation does not tell
   */
  Optional<BlockFaults> faults(int count) {
    divide();
    int differences = unbalanced.stream().mapToInt(region -> Math.abs(region.missing())).sum();
    if (differences != count) {
      return Optional.empty();
    }
    BlockFaults faults = new BlockFaults();
    for (Region region : unbalanced) {
      Optional<BlockFaults> found =
          Math.abs(region.missing()) == 1
              ? new EndSearch(lines, words, region).fault()
              : Optional.empty();
      if (found.isEmpty()) {
        return Optional.empty();
      }
      faults.addAll(found.get());
    }
    return Optional.of(faults);
  }

  private void divide() {
    int from = 0;
    for (int at = 0; at < words.size(); at++) {
      ScriptToken word = words.get(at);
      boolean definition = TokenKinds.opensDefinition(word.getType()) && word.firstOnLine();
      if (definition || word.is(Token.EOF)) {
        region(from, at, definition ? lines.column(word) : 0);
        from = at;
        around.add(word);
      }
    }
  }

  /** What stands before a definition in {@code column}, which only those further out surround. */
  private void region(int from, int to, int column) {
    int left = around.size();
    while (left > 0 && lines.column(around.get(left - 1)) >= column) {
      left--;
    }
    int before = Math.max(0, around.size() - 1);
    int missing = balance(from, to) - (left - before);
    if (missing != 0) {
      unbalanced.add(new Region(from, to, List.copyOf(around.subList(0, before)), left, missing));
    }
    around.subList(left, around.size()).clear();
  }

  /** How many more blocks open than close. */
  private int balance(int from, int to) {
    int balance = 0;
    for (ScriptToken word : words.subList(from, to)) {
      if (TokenKinds.opensBlock(word.getType())) {
        balance++;
      } else if (word.is(END)) {
        balance--;
      }
    }
    return balance;
  }
}
