package org.pendant.desktop.program.form;

import com.formdev.flatlaf.util.UIScale;
import java.awt.EventQueue;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/** Grid view: numbers in columns, filled downwards; what is wrong with them stands below all. */
final class GridView implements FieldView {
  private static final int FIELD_COLUMNS = 5;

  /** Around a label, its field and unit, in pixels before scaling. */
  private static final int GAPS = 16;

  private final JPanel grid;
  private final List<TypedField> fields = new ArrayList<>();
  private final List<JLabel> labels = new ArrayList<>();
  private final List<JLabel> units = new ArrayList<>();
  private final FormText problem;
  private int columns;
  private Item.Grid item;

  GridView(FieldViews views, Item.Grid grid) {
    item = grid;
    this.grid = new JPanel();
    this.grid.setOpaque(false);
    this.grid.setName(views.id(grid.name()));
    for (int i = 0; i < grid.numbers().size(); i++) {
      int index = i;
      Item.Quantity number = grid.numbers().get(i);
      TypedField field =
          new TypedField(
              FIELD_COLUMNS,
              typed -> views.presenter().typeNumber(now(index).name(), typed),
              typed -> canonical(index, typed),
              views.refused());
      field.setHorizontalAlignment(SwingConstants.TRAILING);
      views.named(field, number);
      field.getAccessibleContext().setAccessibleName((grid.label() + " " + number.label()).strip());
      fields.add(field);
      JLabel label = new JLabel(number.label());
      label.setLabelFor(field);
      labels.add(label);
      units.add(new JLabel(number.measure().symbol()));
    }
    problem = new FormText(this.grid.getName() + "-problem", Palette::error).keepingRoom();
    arrange(grid.columns());
    this.grid.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            arrange(fitting());
          }
        });
    show(grid);
  }

  /** As many columns as there is room for: all, or one. */
  private int fitting() {
    int widest = 0;
    for (int i = 0; i < fields.size(); i++) {
      widest =
          Math.max(
              widest,
              labels.get(i).getPreferredSize().width
                  + fields.get(i).getPreferredSize().width
                  + units.get(i).getPreferredSize().width);
    }
    int wanted = item.columns() * (widest + UIScale.scale(GAPS));
    return wanted <= grid.getWidth() ? item.columns() : 1;
  }

  private void arrange(int wanted) {
    if (wanted == columns) {
      return;
    }
    columns = wanted;
    grid.removeAll();
    grid.setLayout(
        new MigLayout(
            "insets 0, gap 4 4, hidemode 3",
            String.join("12", Collections.nCopies(columns, "[][grow, fill][]"))));
    int rows = Math.ceilDiv(fields.size(), columns);
    for (int i = 0; i < fields.size(); i++) {
      int first = 3 * (i / rows);
      grid.add(labels.get(i), "cell " + first + " " + i % rows);
      grid.add(fields.get(i), "cell " + (first + 1) + " " + i % rows + ", wmin 30");
      grid.add(units.get(i), "cell " + (first + 2) + " " + i % rows);
    }
    grid.add(problem, "cell 0 " + rows + " " + 3 * columns + " 1, growx, width 0:10:");
    EventQueue.invokeLater(grid::revalidate);
  }

  private Item.Quantity now(int index) {
    return item.numbers().get(index);
  }

  private String canonical(int index, String typed) {
    if (typed.isBlank()) {
      return "";
    }
    try {
      return now(index).measure().text(now(index).measure().parse(typed));
    } catch (IllegalArgumentException notANumber) {
      return typed;
    }
  }

  @Override
  public JComponent component() {
    return grid;
  }

  @Override
  public JComponent focus() {
    return fields.getFirst();
  }

  /** The field of one of its numbers, if it is there. */
  Optional<JComponent> field(String name) {
    for (int i = 0; i < fields.size(); i++) {
      if (now(i).name().equals(name)) {
        return Optional.of(fields.get(i));
      }
    }
    return Optional.empty();
  }

  @Override
  public void show(Item shown) {
    item = (Item.Grid) shown;
    for (int i = 0; i < fields.size(); i++) {
      fields.get(i).follow(now(i).text());
    }
    setProblem("");
  }

  @Override
  public void setProblem(String found) {
    String said = found;
    for (int i = fields.size() - 1; i >= 0; i--) {
      String refusal = fields.get(i).refusal();
      fields.get(i).outline(!refusal.isEmpty());
      FieldViews.describe(fields.get(i), refusal, now(i).legal());
      said = refusal.isEmpty() ? said : Messages.told(now(i).label(), refusal);
    }
    problem.say(said);
  }
}
