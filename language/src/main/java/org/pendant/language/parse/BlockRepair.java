package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.Token;
import org.pendant.language.source.Source;

/**
 * Block repair: balances blocks: adds the {@code end}s that are missing and drops those that close
 * nothing, each reported once. Indentation has no meaning in URScript, but where the count of
 * {@code end}s is wrong it usually tells which one; it is believed only if it explains the whole
 * difference, first with the slips that most texts have ({@link IndentedRegions}), then to the
 * letter.
 */
final class BlockRepair {
  private final Source source;
  private final Complaints complaints;

  BlockRepair(Source source, Complaints complaints) {
    this.source = source;
    this.complaints = complaints;
  }

  List<ScriptToken> balance(List<ScriptToken> tokens) {
    BlockFaults faults = faults(tokens);
    faults.report(source, complaints);
    return complaints.full() ? tokens : faults.mended(tokens, complaints);
  }

  private BlockFaults faults(List<ScriptToken> tokens) {
    BlockFaults plain = new Pairing(tokens, false, 0).run();
    if (plain.count() == 0 || plain.count() > Complaints.LIMIT) {
      return plain;
    }
    IndentedRegions regions = new IndentedRegions(source, tokens);
    Optional<BlockFaults> likely = regions.single();
    if (likely.isEmpty() && plain.openToDoubt()) {
      likely = regions.faults(plain.count());
    }
    if (likely.isPresent()) {
      return likely.get();
    }
    BlockFaults exact = new Pairing(tokens, true, plain.countStrayEnds()).run();
    return exact.count() <= plain.count() ? exact : plain;
  }

  /** One attempt at pairing openers with ends. */
  private final class Pairing {
    private final List<ScriptToken> tokens;
    private final boolean indentationCounts;
    private final Deque<ScriptToken> open = new ArrayDeque<>();
    private final BlockFaults faults = new BlockFaults();
    private int strayEndsToFind;

    Pairing(List<ScriptToken> tokens, boolean indentationCounts, int strayEndsToFind) {
      this.tokens = tokens;
      this.indentationCounts = indentationCounts;
      this.strayEndsToFind = strayEndsToFind;
    }

    BlockFaults run() {
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
            faults.unclosed(open.pop(), token);
          }
        }
      }
      return faults;
    }

    private void end(ScriptToken end) {
      leaveDeeperBlocks(end);
      if (open.isEmpty()) {
        faults.strayEnd(end);
      } else if (indentationCounts
          && strayEndsToFind > 0
          && end.firstOnLine()
          && open.peek().firstOnLine()
          && column(end) > column(open.peek())) {
        strayEndsToFind--;
        faults.strayEnd(end);
      } else {
        open.pop();
      }
    }

    private void alternative(ScriptToken word) {
      leaveDeeperBlocks(word);
      if (open.stream().noneMatch(opener -> opener.is(IF))) {
        faults.strayElse(word);
        return;
      }
      if (open.stream()
          .takeWhile(opener -> !opener.is(IF))
          .anyMatch(opener -> TokenKinds.opensDefinition(opener.getType()))) {
        faults.strayElse(word);
        return;
      }
      while (!open.peek().is(IF)) {
        faults.unclosed(open.pop(), word);
      }
    }

    /** An end exactly below an outer opener closes that one: the inner ones lack theirs. */
    private void leaveDeeperBlocks(ScriptToken word) {
      if (!indentationCounts
          || !word.firstOnLine()
          || open.stream().noneMatch(o -> o.firstOnLine() && column(o) == column(word))) {
        return;
      }
      while (open.peek().firstOnLine() && column(open.peek()) > column(word)) {
        faults.unclosed(open.pop(), word);
      }
    }

    private int column(ScriptToken token) {
      return source.column(token.startOffset());
    }
  }
}
