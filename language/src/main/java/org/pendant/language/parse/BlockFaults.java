package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.pendant.language.source.Source;

/** Faults of the blocks of a text, by what was probably meant. */
final class BlockFaults {
  private final List<Unclosed> unclosed = new ArrayList<>();
  private final List<Stray> strayEnds = new ArrayList<>();
  private final List<ScriptToken> strayElses = new ArrayList<>();

  /** A block whose {@code end} is missing, and the token in front of which it is noticed. */
  record Unclosed(ScriptToken opener, ScriptToken before) {}

  /** An {@code end} that closes nothing, and why. */
  record Stray(ScriptToken end, String reason) {}

  void unclosed(ScriptToken opener, ScriptToken before) {
    unclosed.add(new Unclosed(opener, before));
  }

  void strayEnd(ScriptToken end) {
    strayEnds.add(new Stray(end, "every block before it has its `end` already"));
  }

  void strayEnd(ScriptToken end, String reason) {
    strayEnds.add(new Stray(end, reason));
  }

  void strayElse(ScriptToken word) {
    strayElses.add(word);
  }

  void addAll(BlockFaults others) {
    unclosed.addAll(others.unclosed);
    strayEnds.addAll(others.strayEnds);
    strayElses.addAll(others.strayElses);
  }

  int count() {
    return unclosed.size() + strayEnds.size() + strayElses.size();
  }

  int countStrayEnds() {
    return strayEnds.size();
  }

  /** Whether these are ends alone, and nothing but their number says which. */
  boolean openToDoubt() {
    return strayElses.isEmpty()
        && unclosed.stream().allMatch(block -> block.before().is(Token.EOF));
  }

  void report(Source source, Complaints complaints) {
    unclosed.sort(Comparator.comparingInt(block -> block.opener().startOffset()));
    for (Unclosed block : unclosed) {
      ScriptToken opener = block.opener();
      complaints.addForBlock(
          "missing-end",
          opener.range(),
          source.text().length(),
          "`"
              + source.text(opener.range())
              + "` on line "
              + opener.getLine()
              + " has no `end`: "
              + noticed(source, block.before()));
    }
    for (Stray stray : strayEnds) {
      complaints.add(
          "stray-end", stray.end().range(), "this `end` closes nothing: " + stray.reason());
    }
    for (ScriptToken word : strayElses) {
      complaints.add(
          "stray-else", word.range(), "`" + source.text(word.range()) + "` belongs to no `if`");
    }
  }

  private static String noticed(Source source, ScriptToken before) {
    return switch (before.getType()) {
      case Token.EOF -> "the text ends inside its block";
      case END, ELSE, ELIF ->
          "the `"
              + source.text(before.range())
              + "` on line "
              + before.getLine()
              + " belongs to an outer block";
      default -> "by its indentation line " + before.getLine() + " is outside of its block";
    };
  }

  /**
   * The tokens as they were meant.
   *
   * @param complaints note where they differ
   */
  List<ScriptToken> mended(List<ScriptToken> tokens, Complaints complaints) {
    if (count() == 0) {
      return tokens;
    }
    Map<ScriptToken, Integer> missingBefore = new HashMap<>();
    unclosed.forEach(block -> missingBefore.merge(block.before(), 1, Integer::sum));
    Set<ScriptToken> dropped = new HashSet<>(strayElses);
    strayEnds.forEach(stray -> dropped.add(stray.end()));
    List<ScriptToken> mended = new ArrayList<>(tokens.size());
    boolean inDroppedHead = false;
    for (ScriptToken token : tokens) {
      for (int i = missingBefore.getOrDefault(token, 0); i > 0; i--) {
        complaints.note(token.range());
        mended.add(ScriptToken.missing(END, token));
      }
      // A stray else takes the rest of its head along.
      inDroppedHead &= !token.firstOnLine() && !token.is(Token.EOF);
      if (dropped.contains(token) || inDroppedHead) {
        complaints.note(token.range());
      }
      if (dropped.contains(token)) {
        inDroppedHead = !token.is(END);
      } else if (!inDroppedHead) {
        mended.add(token);
      } else if (token.is(COLON)) {
        inDroppedHead = false;
      }
    }
    return mended;
  }
}
