package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.antlr.v4.runtime.Token;
import org.pendant.language.source.Source;

/**
 * Balances blocks: adds the {@code end}s that are missing and drops those that close nothing, each
 * reported once. Indentation has no meaning in URScript, but where the count of {@code end}s is
 * wrong it usually tells which one; it is believed only if it explains the whole difference.
 */
final class BlockRepair {
  private final Source source;
  private final Complaints complaints;

  BlockRepair(Source source, Complaints complaints) {
    this.source = source;
    this.complaints = complaints;
  }

  List<ScriptToken> balance(List<ScriptToken> tokens) {
    Pairing plain = new Pairing(tokens, false, 0);
    plain.run();
    Pairing chosen = plain;
    if (!plain.perfect() && plain.problems() <= Complaints.LIMIT) {
      Pairing byIndentation = new Pairing(tokens, true, plain.strayEnds.size());
      byIndentation.run();
      if (byIndentation.problems() <= plain.problems()) {
        chosen = byIndentation;
      }
    }
    chosen.report();
    return complaints.full() ? tokens : chosen.mended();
  }

  /** A block whose {@code end} is missing, and the token in front of which it is noticed. */
  private record Unclosed(ScriptToken opener, ScriptToken before) {}

  /** One attempt at pairing openers with ends. */
  private final class Pairing {
    private final List<ScriptToken> tokens;
    private final boolean indentationCounts;
    private final Deque<ScriptToken> open = new ArrayDeque<>();
    private final List<Unclosed> unclosed = new ArrayList<>();
    private final List<ScriptToken> strayEnds = new ArrayList<>();
    private final List<ScriptToken> strayElses = new ArrayList<>();
    private int strayEndsToFind;

    Pairing(List<ScriptToken> tokens, boolean indentationCounts, int strayEndsToFind) {
      this.tokens = tokens;
      this.indentationCounts = indentationCounts;
      this.strayEndsToFind = strayEndsToFind;
    }

    boolean perfect() {
      return problems() == 0;
    }

    int problems() {
      return unclosed.size() + strayEnds.size() + strayElses.size();
    }

    void run() {
      for (ScriptToken token : tokens) {
        int type = token.getType();
        if (TokenKinds.opensBlock(type)) {
          open.push(token);
        } else if (type == END) {
          end(token);
        } else if (type == ELSE || type == ELIF) {
          alternative(token);
        } else if (type == Token.EOF) {
          while (!open.isEmpty()) {
            unclosed.add(new Unclosed(open.pop(), token));
          }
        }
      }
    }

    private void end(ScriptToken end) {
      leaveDeeperBlocks(end);
      if (open.isEmpty()) {
        strayEnds.add(end);
      } else if (indentationCounts
          && strayEndsToFind > 0
          && end.firstOnLine()
          && open.peek().firstOnLine()
          && column(end) > column(open.peek())) {
        strayEndsToFind--;
        strayEnds.add(end);
      } else {
        open.pop();
      }
    }

    private void alternative(ScriptToken word) {
      leaveDeeperBlocks(word);
      if (open.stream().noneMatch(opener -> opener.is(IF))) {
        strayElses.add(word);
        return;
      }
      if (open.stream().takeWhile(opener -> !opener.is(IF)).anyMatch(this::definition)) {
        strayElses.add(word);
        return;
      }
      while (!open.peek().is(IF)) {
        unclosed.add(new Unclosed(open.pop(), word));
      }
    }

    private boolean definition(ScriptToken opener) {
      return opener.is(DEF) || opener.is(SEC) || opener.is(THREAD);
    }

    /** An end exactly below an outer opener closes that one: the inner ones lack theirs. */
    private void leaveDeeperBlocks(ScriptToken word) {
      if (!indentationCounts
          || !word.firstOnLine()
          || open.stream().noneMatch(o -> o.firstOnLine() && column(o) == column(word))) {
        return;
      }
      while (open.peek().firstOnLine() && column(open.peek()) > column(word)) {
        unclosed.add(new Unclosed(open.pop(), word));
      }
    }

    void report() {
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
                + " has no `end`"
                + (block.before().is(Token.EOF)
                    ? ": the text ends inside its block"
                    : ": the `"
                        + source.text(block.before().range())
                        + "` on line "
                        + block.before().getLine()
                        + " belongs to an outer block"));
      }
      for (ScriptToken end : strayEnds) {
        complaints.add(
            "stray-end",
            end.range(),
            "this `end` closes nothing: every block before it has its `end` already");
      }
      for (ScriptToken word : strayElses) {
        complaints.add(
            "stray-else", word.range(), "`" + source.text(word.range()) + "` belongs to no `if`");
      }
    }

    List<ScriptToken> mended() {
      if (perfect()) {
        return tokens;
      }
      Map<ScriptToken, Integer> missingBefore = new HashMap<>();
      unclosed.forEach(block -> missingBefore.merge(block.before(), 1, Integer::sum));
      Set<ScriptToken> dropped = new HashSet<>(strayEnds);
      dropped.addAll(strayElses);
      List<ScriptToken> mended = new ArrayList<>(tokens.size());
      boolean inDroppedHead = false;
      for (ScriptToken token : tokens) {
        for (int i = missingBefore.getOrDefault(token, 0); i > 0; i--) {
          mended.add(ScriptToken.missing(END, token));
        }
        // A stray else takes the rest of its head along.
        inDroppedHead &= !token.firstOnLine() && !token.is(Token.EOF);
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

    private int column(ScriptToken token) {
      return source.column(token.startOffset());
    }
  }
}
