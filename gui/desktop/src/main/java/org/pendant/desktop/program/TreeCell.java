package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.ListCellRenderer;
import javax.swing.UIManager;
import org.pendant.desktop.editor.Execution;
import org.pendant.desktop.editor.LineIcon;
import org.pendant.desktop.editor.LineNote;
import org.pendant.desktop.editor.text.RichText;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.check.NodeProblem;

/** Tree cell: what the rows look like besides their nodes. */
@SuppressWarnings("serial") // never written to a stream
final class TreeCell extends JLabel implements ListCellRenderer<TreeRow> {
  private static final int MARGIN = 20;
  private static final int INDENT = 16;
  private static final int TWISTY = 14;
  private static final int GAP = 5;
  private static final int HEAT = 3;
  private static final int NOTE_GAP = 16;
  private static final SvgIcon INCOMPLETE = SvgIcon.of("mark/incomplete", 14);

  private final transient TreeLooks looks;
  private transient Optional<TreeRow> row = Optional.empty();
  private boolean selected;
  private boolean focused;
  private boolean active;
  private int problemWidth;

  /** What the rows look like besides their nodes. */
  interface TreeLooks {
    TreeMarks marks();

    /** How many digits the largest number has. */
    int digits();

    List<NodeProblem> problems(long key);

    boolean found(long key);

    /** What people call a node. */
    String label(TreeRow row);
  }

  TreeCell(TreeLooks looks) {
    this.looks = looks;
    setOpaque(false);
  }

  /** Where the marks end, from the left. */
  static int margin() {
    return UIScale.scale(MARGIN);
  }

  private int numberWidth() {
    return getFontMetrics(getFont()).charWidth('0') * Math.max(2, looks.digits());
  }

  /** Where the arrow that folds a row of a depth begins. */
  int twistyX(int depth) {
    return margin() + numberWidth() + UIScale.scale(GAP + depth * INDENT);
  }

  /** Where the text of a row of a depth begins. */
  int textX(int depth) {
    return twistyX(depth) + UIScale.scale(TWISTY + StepIcon.SIDE + GAP);
  }

  static int twistyWidth() {
    return UIScale.scale(TWISTY);
  }

  /** How deep a place from the left is, in levels. */
  double depthAt(int x) {
    return (x - twistyX(0) - twistyWidth()) / (double) UIScale.scale(INDENT);
  }

  @Override
  public Component getListCellRendererComponent(
      JList<? extends TreeRow> list,
      TreeRow value,
      int index,
      boolean isSelected,
      boolean hasFocus) {
    row = Optional.of(value);
    selected = isSelected;
    focused = hasFocus;
    active = list.isFocusOwner();
    setFont(list.getFont());
    setText(spoken(value));
    return this;
  }

  /** What a screen reader says. */
  private String spoken(TreeRow shown) {
    List<String> said = new ArrayList<>();
    said.add(text("line", shown.number()));
    said.add(looks.label(shown));
    said.add(text("level", shown.depth() + 1));
    if (shown.hasChildren()) {
      said.add(text(shown.folded() ? "folded" : "unfolded"));
    }
    if (shown.off()) {
      said.add(text("suppressed"));
    }
    if (looks.marks().breakpoints().containsKey(shown.key())) {
      said.add(text("breakpoint"));
    }
    if (looks.marks().execution() == shown.key()) {
      said.add(text(looks.marks().state() == Execution.State.RUNNING ? "runs" : "paused"));
    }
    Optional.ofNullable(looks.marks().notes().get(shown.key()))
        .ifPresent(note -> said.add(note.heat()));
    looks.problems(shown.key()).stream()
        .findFirst()
        .ifPresent(
            problem ->
                said.add(text(problem.blocks() ? "notComplete" : "warning", problem.message())));
    return Messages.joined(said);
  }

  @Override
  protected void paintComponent(Graphics g) {
    row.ifPresent(
        shown -> {
          Graphics2D pen = (Graphics2D) g.create();
          pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
          Object hints = UIManager.get(RenderingHints.KEY_TEXT_ANTIALIASING);
          pen.setRenderingHint(
              RenderingHints.KEY_TEXT_ANTIALIASING,
              hints == null ? RenderingHints.VALUE_TEXT_ANTIALIAS_ON : hints);
          paint(pen, shown);
          pen.dispose();
        });
  }

  private void paint(Graphics2D pen, TreeRow shown) {
    TreeMarks marks = looks.marks();
    boolean here = marks.execution() == shown.key();
    Color text = UIManager.getColor("List.foreground");
    if (selected) {
      pen.setColor(
          UIManager.getColor(
              active ? "List.selectionBackground" : "List.selectionInactiveBackground"));
      // marks keep what is behind them in other rows: green on blue cannot be seen
      pen.fillRect(margin(), 0, getWidth(), getHeight());
      text =
          UIManager.getColor(
              active ? "List.selectionForeground" : "List.selectionInactiveForeground");
    } else if (here) {
      boolean failed = marks.state() == Execution.State.FAILED;
      pen.setColor(Palette.tint(failed ? Palette.error() : Palette.ok(), 0.14));
      pen.fillRect(margin(), 0, getWidth(), getHeight());
    } else if (looks.found(shown.key())) {
      pen.setColor(Palette.mark());
      pen.fillRect(textX(shown.depth()) - UIScale.scale(2), 0, getWidth(), getHeight());
    }
    paintMargin(pen, shown, marks);
    Color quiet = selected ? text : Palette.quiet();
    paintNumber(pen, shown, quiet);
    Optional<LineNote> note = Optional.ofNullable(marks.notes().get(shown.key()));
    note.ifPresent(took -> paintHeat(pen, took));
    if (shown.hasChildren()) {
      paintTwisty(pen, twistyX(shown.depth()), shown.folded(), quiet);
    }
    Color own = shown.off() ? quiet : text;
    int iconX = twistyX(shown.depth()) + twistyWidth();
    SvgIcon icon = StepIcon.of(shown.node().step());
    SvgIcon look = shown.off() ? icon.in(quiet) : selected ? icon.in(text) : icon;
    look.paintIcon(this, pen, iconX, middle(icon.getIconHeight()));
    int end = paintLabel(pen, shown, own);
    note.ifPresent(took -> paintNote(pen, took, end, quiet));
    if (focused) {
      pen.setColor(Palette.accent());
      pen.drawRect(margin(), 0, getWidth() - margin() - 1, getHeight() - 1);
    }
  }

  private int middle(int height) {
    return (getHeight() - height) / 2;
  }

  private void paintMargin(Graphics2D pen, TreeRow shown, TreeMarks marks) {
    int x = UIScale.scale(2);
    Optional<LineIcon> icon = marks.icon(shown.key());
    if (icon.isPresent()) {
      icon.get().paintIcon(this, pen, x, middle(icon.get().getIconHeight()));
    } else if (marks.threads().contains(shown.key())) {
      pen.setColor(Palette.ok());
      int size = UIScale.scale(6);
      pen.fillOval(x + UIScale.scale(5), middle(size), size, size);
    }
  }

  private void paintNumber(Graphics2D pen, TreeRow shown, Color color) {
    FontMetrics metrics = getFontMetrics(getFont());
    String number = String.valueOf(shown.number());
    pen.setFont(getFont());
    pen.setColor(color);
    int right = margin() + numberWidth();
    pen.drawString(number, right - metrics.stringWidth(number), baseline(metrics));
  }

  private int baseline(FontMetrics metrics) {
    return (getHeight() - metrics.getHeight()) / 2 + metrics.getAscent();
  }

  private void paintTwisty(Graphics2D pen, int x, boolean folded, Color color) {
    Graphics2D own = (Graphics2D) pen.create();
    own.translate(x, middle(UIScale.scale(TWISTY)));
    UIScale.scaleGraphics(own);
    own.setColor(color);
    own.setStroke(new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    Path2D arrow = new Path2D.Double();
    if (folded) {
      arrow.moveTo(4.5, 3);
      arrow.lineTo(8.5, 7);
      arrow.lineTo(4.5, 11);
    } else {
      arrow.moveTo(2.5, 5);
      arrow.lineTo(6.5, 9);
      arrow.lineTo(10.5, 5);
    }
    own.draw(arrow);
    own.dispose();
  }

  /** How warm the node is, behind its number. */
  private void paintHeat(Graphics2D pen, LineNote note) {
    pen.setColor(note.heatColour());
    pen.fillRect(margin() + numberWidth() + UIScale.scale(2), 0, UIScale.scale(HEAT), getHeight());
  }

  /** What the node took, at the right edge where there is room. */
  private void paintNote(Graphics2D pen, LineNote note, int from, Color color) {
    FontMetrics metrics = getFontMetrics(getFont());
    int right = getWidth() - UIScale.scale(GAP) - problemWidth;
    String text = note.fitting(metrics, right - from - UIScale.scale(NOTE_GAP));
    pen.setColor(color);
    pen.drawString(text, right - metrics.stringWidth(text), baseline(metrics));
  }

  /** Answers where the label ends. */
  private int paintLabel(Graphics2D pen, TreeRow shown, Color color) {
    FontMetrics metrics = getFontMetrics(getFont());
    int x = textX(shown.depth());
    int right = getWidth() - UIScale.scale(GAP);
    problemWidth = 0;
    boolean incomplete = !shown.off() && !looks.problems(shown.key()).isEmpty();
    if (incomplete) {
      SvgIcon icon = selected ? INCOMPLETE.in(color) : INCOMPLETE;
      problemWidth = icon.getIconWidth() + UIScale.scale(GAP);
      right -= problemWidth;
      icon.paintIcon(this, pen, right + UIScale.scale(GAP), middle(icon.getIconHeight()));
    }
    String label = clipped(looks.label(shown), metrics, right - x);
    pen.setFont(getFont());
    pen.setColor(incomplete && !selected ? Palette.warning() : color);
    pen.drawString(label, x, baseline(metrics));
    if (shown.off()) {
      int y = baseline(metrics) - metrics.getAscent() / 3;
      pen.drawLine(x, y, x + metrics.stringWidth(label), y);
    }
    return x + metrics.stringWidth(label);
  }

  /** What a row says where the pointer rests on it. */
  static String tip(String label, List<NodeProblem> problems, Optional<LineNote> note) {
    String text =
        problems.isEmpty()
            ? label
            : label + " \u2013 " + Messages.shown(problems.getFirst().message());
    return note.map(took -> RichText.lines(text + "\n" + took.whole())).orElse(text);
  }

  private static String clipped(String label, FontMetrics metrics, int room) {
    if (metrics.stringWidth(label) <= room) {
      return label;
    }
    int end = label.length();
    while (end > 0 && metrics.stringWidth(label.substring(0, end) + "\u2026") > room) {
      end--;
    }
    return label.substring(0, end) + "\u2026";
  }
}
