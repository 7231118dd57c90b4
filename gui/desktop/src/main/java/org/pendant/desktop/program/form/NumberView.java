package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.awt.Insets;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.Squeeze;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.NumberRange;

/** Number view: a number with its unit, and what is legal where there is room for it. */
final class NumberView implements FieldView {
  private static final int COLUMNS = 7;
  private static final int FEW_COLUMNS = 5;

  /** Width of a field at least; in a narrow form its unit stays in sight before more of it does. */
  private static final int LEAST = 64;

  private final TypedField field;
  private final JLabel unit = new JLabel();
  private final JLabel legal = new JLabel();
  private final JPanel row = new JPanel(new MigLayout("insets 0, gap 6, hidemode 3", "[][][grow]"));
  private final FieldPanel panel;
  private final Squeeze squeeze;
  private final boolean hinted;
  private Item.Quantity item;

  /**
   * A field for a number.
   *
   * @param hinted whether it may say what is legal
   */
  NumberView(FieldViews views, Item.Quantity number, boolean hinted) {
    item = number;
    this.hinted = hinted;
    field =
        new TypedField(
            hinted ? COLUMNS : FEW_COLUMNS,
            typed -> views.presenter().typeNumber(item.name(), typed),
            this::canonical,
            views.refused());
    field.setHorizontalAlignment(SwingConstants.TRAILING);
    views.named(field, number);
    unit.setLabelFor(field);
    row.setOpaque(false);
    row.add(field, "wmin " + least());
    row.add(unit);
    legal.setForeground(Palette.quiet());
    row.add(legal);
    squeeze = new Squeeze(row, List.of(legal::setVisible));
    panel = new FieldPanel(row, field.getName(), field::refusal);
    show(number);
  }

  /** What it means when it is empty can be read in it. */
  private int least() {
    Insets insets = field.getInsets();
    int words = field.getFontMetrics(field.getFont()).stringWidth(item.whenEmpty());
    return Math.max(LEAST, words + insets.left + insets.right);
  }

  private String canonical(String typed) {
    if (typed.isBlank()) {
      return "";
    }
    try {
      return item.measure().text(item.measure().parse(typed));
    } catch (IllegalArgumentException notANumber) {
      return typed;
    }
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public JComponent focus() {
    return field;
  }

  @Override
  public void show(Item shown) {
    item = (Item.Quantity) shown;
    field.follow(item.text());
    field.putClientProperty(
        "JTextField.placeholderText", item.whenEmpty().isEmpty() ? null : item.whenEmpty());
    unit.setText(item.measure().symbol());
    String range = range();
    if (!legal.getText().equals(range)) {
      legal.setText(range);
      squeeze.fitLater();
    }
    setProblem("");
  }

  /** What is usual, and whose limits these are if more is legal. */
  private String range() {
    NumberRange usual = item.usual();
    if (!hinted || usual.max() >= 1e6 || usual.min() == Double.NEGATIVE_INFINITY) {
      return "";
    }
    String max = item.measure().brief(usual.max());
    boolean everywhere = usual.equals(item.field().range());
    return usual.min() == 0
        ? text(everywhere ? "upTo" : "upToHere", max)
        : text(everywhere ? "fromTo" : "fromToHere", item.measure().brief(usual.min()), max);
  }

  @Override
  public void setProblem(String problem) {
    String said = panel.say(problem);
    field.outline(!said.isEmpty());
    FieldViews.describe(field, said, item.legal());
  }
}
