package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.script.coverage.CoverageSite;
import org.pendant.script.coverage.CoverageSite.Kind;

/**
 * Coverage points: the places of one function that are marked when they are reached; none unless
 * its program is compiled for coverage.
 */
final class CoveragePoints {
  /** What a place has that is not marked. */
  static final int NONE = -1;

  private record Point(Kind kind, SourceRange range, int slot) {}

  private final CodeBuilder code;
  private final Optional<CoverageSlots> slots;
  private final List<Point> points = new ArrayList<>();

  /** The mark that the next statement has already, because only that way leads to it. */
  private int entered = NONE;

  private final UnmarkedStatements unmarked = new UnmarkedStatements();

  /** The statement before, if the next one stands for it. */
  private int open = NONE;

  private int openPc;

  CoveragePoints(CodeBuilder code, Optional<CoverageSlots> slots) {
    this.code = code;
    this.slots = slots;
  }

  /** Whether anything is marked. */
  boolean wanted() {
    return slots.isPresent();
  }

  /**
   * A statement begins here.
   *
   * @param implied whether another one follows, which is always come to by this one and marks both
   */
  void statement(SourceRange head, boolean implied) {
    if (slots.isEmpty()) {
      return;
    }
    boolean shared = entered != NONE;
    int slot = shared ? entered : add(Kind.STATEMENT, head);
    if (shared) {
      points.add(new Point(Kind.STATEMENT, head, entered));
      entered = NONE;
    }
    if (open != NONE) {
      unmarked.add(openPc, code.size(), open);
      slots.get().imply(open, slot);
      open = NONE;
    }
    if (implied) {
      open = slot;
      openPc = code.size();
    } else if (!shared) {
      mark(slot);
    }
  }

  /** The statements that leave no mark of their own. */
  UnmarkedStatements unmarked() {
    return unmarked;
  }

  /** What comes next begins a block that only {@code truth} of {@code decision} leads to. */
  void enter(int decision, boolean truth) {
    entered = slot(decision, truth);
  }

  /** The block ends, whether or not it had a statement. */
  void leave() {
    entered = NONE;
  }

  /** The condition of a statement. */
  int branch(SourceRange condition) {
    return add(Kind.BRANCH, condition);
  }

  /** An operand of {@code and} or {@code or}. */
  int operand(SourceRange operand) {
    return add(Kind.CONDITION, operand);
  }

  /** Here {@code decision}, which {@link #branch} or {@link #operand} answered, is known. */
  void decided(int decision, boolean truth) {
    mark(slot(decision, truth));
  }

  private static int slot(int decision, boolean truth) {
    return decision == NONE ? NONE : decision + (truth ? 1 : 0);
  }

  private int add(Kind kind, SourceRange range) {
    if (slots.isEmpty()) {
      return NONE;
    }
    int slot = slots.get().take(kind.twoWay() ? 2 : 1);
    points.add(new Point(kind, range, slot));
    return slot;
  }

  private void mark(int slot) {
    if (slot != NONE) {
      code.emitUnpaid(Instruction.jump(Op.MARK, 0, slot));
    }
  }

  /**
   * The function ends here.
   *
   * @param nameRange where its name stands; empty for what is no function of the text
   */
  void end(Source source, String name, Optional<SourceRange> nameRange) {
    if (slots.isEmpty()) {
      return;
    }
    String function = nameRange.isPresent() ? name : "";
    if (nameRange.isPresent()) {
      // what is put into functions for tests stands where their names do, and is none of the text
      points.removeIf(point -> point.range().equals(nameRange.get()));
      points.add(new Point(Kind.FUNCTION, nameRange.get(), entry()));
    }
    for (Point point : points) {
      int line = source.line(point.range().start());
      slots.get().add(new CoverageSite(point.kind(), point.range(), line, function, point.slot()));
    }
  }

  /** The mark of the function: that of its first statement, or one of its own. */
  private int entry() {
    for (Point point : points) {
      if (point.kind() == Kind.STATEMENT) {
        return point.slot();
      }
    }
    int slot = slots.orElseThrow().take(1);
    mark(slot);
    return slot;
  }
}
