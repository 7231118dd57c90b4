package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;
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

  /** An {@code end} that closes nothing, and what is said about it. */
  record Stray(ScriptToken end, String message) {}

  void unclosed(ScriptToken opener, ScriptToken before) {
    unclosed.add(new Unclosed(opener, before));
  }

  void strayEnd(ScriptToken end) {
    strayEnd(end, text("strayEnd"));
  }

  void strayEnd(ScriptToken end, String message) {
    strayEnds.add(new Stray(end, message));
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
          noEnd(source, opener, block.before()));
    }
    for (Stray stray : strayEnds) {
      complaints.add("stray-end", stray.end().range(), stray.message());
    }
    for (ScriptToken word : strayElses) {
      complaints.add("stray-else", word.range(), text("strayElse", source.text(word.range())));
    }
  }

  private static String noEnd(Source source, ScriptToken opener, ScriptToken before) {
    String word = source.text(opener.range());
    int line = opener.getLine();
    return switch (before.getType()) {
      case Token.EOF -> text("noEndBeforeTextEnds", word, line);
      case END, ELSE, ELIF ->
          text("noEndBeforeOuterBlock", word, line, source.text(before.range()), before.getLine());
      default -> text("noEndByIndentation", word, line, before.getLine());
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
