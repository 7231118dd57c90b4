package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;
import static org.pendant.language.parse.UrScriptParser.*;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * End search: finds the one {@code end} that a part of a text lacks or has too many. It looks for
 * the place where adding or removing one leaves the fewest blocks whose {@code end}, {@code else}
 * and inner blocks are not in the columns where they are expected.
 *
 * <p>Words before that place are paired from the first one on, words after it from the last one
 * back, so one pass in each direction suffices, with a look at the blocks that are open at each
 * place. Of several places that are equally good the last one is taken, where a parser that only
 * counts would report the fault.
 */
final class EndSearch {
  /** Longest part that is searched, in words: people write shorter ones, and it takes memory. */
  private static final int MAX_WORDS = 100_000;

  /** Cost of an {@code else} where there can be none, above that of any indentation. */
  private static final int WRONG_WORD = 1_000_000;

  /** The column of a word that is not the first on its line. */
  private static final int UNKNOWN = 0;

  private static final int NO_ELSE = -1;

  private final IndentedLines lines;
  private final List<ScriptToken> words;
  private final IndentedRegions.Region region;

  /** First words of blocks without indentation, in which columns tell nothing. */
  private final Set<ScriptToken> flat;

  /** Whether columns tell anything in this part. */
  private final boolean indented;

  /**
   * For each word and the end: the blocks that are closed later, paired from the last word back.
   */
  private final Open[] behind;

  /** For each of them: the cost of the blocks that are wholly after it. */
  private final int[] costBehind;

  /** The first place that can be right: before it, too few blocks are closed later. */
  private int firstPlace;

  /**
   * What is known of a block, paired from one side or from both.
   *
   * @param word its first, or its last as long as the first is not known
   * @param endColumn that of its {@code end}
   * @param elseColumn that of an {@code else} or {@code elif} in it
   * @param hasElse whether there is an {@code else}
   * @param elseFirst whether something follows that {@code else}
   * @param innerColumn that of the block in it that stands furthest out
   * @param definitionColumn that of the definition among them that does
   */
  private record Block(
      ScriptToken word,
      int endColumn,
      int elseColumn,
      boolean hasElse,
      boolean elseFirst,
      int innerColumn,
      int definitionColumn) {

    private static final int FAR_IN = Integer.MAX_VALUE;

    static Block openedBy(ScriptToken word) {
      return new Block(word, UNKNOWN, NO_ELSE, false, false, FAR_IN, FAR_IN);
    }

    static Block closedBy(ScriptToken word, int column) {
      return new Block(word, column, NO_ELSE, false, false, FAR_IN, FAR_IN);
    }

    /** A part of a block that begins with an {@code else} or {@code elif}. */
    static Block dividedBy(ScriptToken word, int column) {
      return new Block(word, UNKNOWN, column, word.is(ELSE), false, FAR_IN, FAR_IN);
    }

    Block withInner(ScriptToken inner, int column) {
      if (column == UNKNOWN) {
        return this;
      }
      boolean definition = TokenKinds.opensDefinition(inner.getType());
      return new Block(
          word,
          endColumn,
          elseColumn,
          hasElse,
          elseFirst,
          Math.min(innerColumn, column),
          definition ? Math.min(definitionColumn, column) : definitionColumn);
    }

    private Block at(ScriptToken other) {
      return new Block(
          other, endColumn, elseColumn, hasElse, elseFirst, innerColumn, definitionColumn);
    }

    /** The block of which this is the first and {@code rest} the last part. */
    Block with(Block rest) {
      return new Block(
          word,
          rest.endColumn,
          Math.max(elseColumn, rest.elseColumn),
          hasElse || rest.hasElse,
          elseFirst || rest.elseFirst || (hasElse && rest.elseColumn != NO_ELSE),
          Math.min(innerColumn, rest.innerColumn),
          Math.min(definitionColumn, rest.definitionColumn));
    }
  }

  /** Open blocks, the innermost first. */
  private record Open(Optional<Block> innermost, Optional<Open> around, int depth) {
    static final Open NOTHING = new Open(Optional.empty(), Optional.empty(), 0);

    Block block() {
      return innermost.orElseThrow();
    }

    Open outer() {
      return around.orElseThrow();
    }

    Open push(Block block) {
      return new Open(Optional.of(block), Optional.of(this), depth + 1);
    }

    Open changed(Block block) {
      return new Open(Optional.of(block), around, depth);
    }

    Open withInner(ScriptToken inner, int column) {
      return depth == 0 ? this : changed(block().withInner(inner, column));
    }
  }

  EndSearch(IndentedLines lines, List<ScriptToken> words, IndentedRegions.Region region) {
    this.lines = lines;
    this.words = words;
    this.region = region;
    behind = new Open[region.to() - region.from() + 1];
    costBehind = new int[behind.length];
    flat =
        words.subList(region.from(), region.to()).stream()
            .filter(word -> TokenKinds.opensBlock(word.getType()) && !lines.indents(word))
            .collect(Collectors.toSet());
    indented =
        words.subList(region.from(), region.to()).stream()
                .mapToInt(lines::column)
                .filter(column -> column != UNKNOWN)
                .distinct()
                .limit(2)
                .count()
            > 1;
  }

  /** The fault, if there is a place that leaves everything paired. */
  Optional<BlockFaults> fault() {
    if (behind.length > MAX_WORDS) {
      return Optional.empty();
    }
    lookBack();
    return region.missing() > 0 ? missing() : surplus();
  }

  private void lookBack() {
    Open open = Open.NOTHING;
    int cost = 0;
    firstPlace = region.to();
    behind[behind.length - 1] = open;
    for (int at = region.to() - 1; at >= region.from(); at--) {
      ScriptToken word = words.get(at);
      if (word.is(END)) {
        open = open.push(Block.closedBy(word, lines.column(word)));
      } else if (open.depth() == 0) {
        return;
      } else if (TokenKinds.opensBlock(word.getType())) {
        cost += cost(Block.openedBy(word).with(open.block()));
        open = open.outer().withInner(word, lines.column(word));
      } else {
        Block rest = Block.dividedBy(word, lines.column(word)).with(open.block());
        open = open.changed(rest.at(open.block().word()));
      }
      behind[at - region.from()] = open;
      costBehind[at - region.from()] = cost;
      firstPlace = at;
    }
  }

  private Optional<BlockFaults> missing() {
    Open open = around();
    int cost = 0;
    int best = WRONG_WORD - 1;
    int place = region.to();
    Optional<ScriptToken> opener = Optional.empty();
    for (int at = region.from(); ; at++) {
      if (at >= firstPlace && open.depth() == region.left() + behind(at).depth() + 1) {
        int total = cost + cost(open.block()) + across(open.outer(), behind(at)) + costBehind(at);
        if (total <= best) {
          best = total;
          opener = Optional.of(open.block().word());
          place = at;
        }
      }
      if (at == region.to()) {
        break;
      }
      ScriptToken word = words.get(at);
      if (word.is(END)) {
        if (open.depth() <= region.left()) {
          break;
        }
        cost += cost(open.block().with(Block.closedBy(word, lines.column(word))));
      }
      open = after(word, open);
    }
    int before = place;
    return opener.map(
        block -> {
          BlockFaults faults = new BlockFaults();
          faults.unclosed(
              block,
              indented
                  ? lines.outside(block, words.get(before - 1), words.get(before))
                  : words.get(before));
          return faults;
        });
  }

  private Optional<BlockFaults> surplus() {
    Open open = around();
    int cost = 0;
    int best = WRONG_WORD - 1;
    Optional<BlockFaults> found = Optional.empty();
    for (int at = region.from(); at < region.to(); at++) {
      ScriptToken word = words.get(at);
      if (word.is(END)) {
        if (at + 1 >= firstPlace && open.depth() == region.left() + behind(at + 1).depth()) {
          int total = cost + across(open, behind(at + 1)) + costBehind(at + 1);
          if (total <= best) {
            best = total;
            found = Optional.of(stray(word, open, behind(at + 1)));
          }
        }
        if (open.depth() <= region.left()) {
          return found;
        }
        cost += cost(open.block().with(Block.closedBy(word, lines.column(word))));
      }
      open = after(word, open);
    }
    return found;
  }

  private static BlockFaults stray(ScriptToken end, Open open, Open behind) {
    BlockFaults faults = new BlockFaults();
    if (open.depth() == 0) {
      faults.strayEnd(end);
    } else {
      ScriptToken opener = open.block().word();
      Optional<ScriptToken> own = behind.innermost().map(Block::word);
      String word = opener.getText();
      int line = opener.getLine();
      faults.strayEnd(
          end,
          own.isPresent()
              ? text("strayEndBlockEnded", word, line, own.get().getLine())
              : text("strayEndBlockContinues", word, line));
    }
    return faults;
  }

  private Open around() {
    Open open = Open.NOTHING;
    for (ScriptToken opener : region.around()) {
      open = open.push(Block.openedBy(opener));
    }
    return open;
  }

  private Open after(ScriptToken word, Open open) {
    if (TokenKinds.opensBlock(word.getType())) {
      return open.withInner(word, lines.column(word)).push(Block.openedBy(word));
    }
    if (word.is(END)) {
      return open.outer();
    }
    return open.depth() == 0
        ? open
        : open.changed(open.block().with(Block.dividedBy(word, lines.column(word))));
  }

  private Open behind(int place) {
    return behind[place - region.from()];
  }

  private int costBehind(int place) {
    return costBehind[place - region.from()];
  }

  /** What the blocks cost that are open before a place and closed after it. */
  private int across(Open before, Open after) {
    int cost = 0;
    Open first = before;
    for (Open last = after; last.depth() > 0; last = last.outer()) {
      cost += cost(first.block().with(last.block()));
      first = first.outer();
    }
    return cost;
  }

  private int cost(Block block) {
    ScriptToken opener = block.word();
    boolean misplaced = block.elseColumn() != NO_ELSE && !opener.is(IF);
    int wrong = misplaced || block.elseFirst() ? WRONG_WORD : 0;
    int column = lines.column(opener);
    if (!indented || column == UNKNOWN) {
      return wrong;
    }
    return wrong
        + (block.endColumn() != UNKNOWN && block.endColumn() != column ? 1 : 0)
        + (block.elseColumn() > UNKNOWN && block.elseColumn() != column ? 1 : 0)
        + (block.innerColumn() <= column && !flat.contains(opener) ? 1 : 0)
        + (block.definitionColumn() <= column ? 1 : 0);
  }
}
