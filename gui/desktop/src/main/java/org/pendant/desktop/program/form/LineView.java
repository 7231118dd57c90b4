package org.pendant.desktop.program.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.WrappingRow;

/** Line view: several controls beside each other; those of fixed width wrap where it is narrow. */
final class LineView implements FieldView {
  private final JPanel row;
  private final Optional<JComponent> lead;
  private final List<FieldView> views = new ArrayList<>();

  LineView(FieldViews views, Item.Line line) {
    boolean texts = line.items().stream().anyMatch(each -> each instanceof Item.Expression);
    row =
        new JPanel(
            texts ? new MigLayout("insets 0, gap 4, fillx") : new WrappingRow(PressesView.GAP));
    if (!texts) {
      PressesView.bare(row);
    }
    row.setOpaque(false);
    row.setName(views.id(line.name()));
    for (Item each : line.items()) {
      FieldView view = view(views, each);
      this.views.add(view);
      if (leads(line, each)) {
        continue;
      }
      JComponent shown =
          each instanceof Item.Quantity && !each.label().isEmpty()
              ? labelled(each.label(), view)
              : view.component();
      if (texts) {
        row.add(shown, "aligny top" + width(each));
      } else {
        row.add(shown);
      }
    }
    lead =
        leads(line, line.items().getFirst())
            ? Optional.of(this.views.getFirst().component())
            : Optional.empty();
  }

  /** Whether an item is a check that stands before all others. */
  @SuppressWarnings("ReferenceEquality") // the same item, not one that is like it
  private static boolean leads(Item.Line line, Item item) {
    return item instanceof Item.Check && line.items().getFirst() == item;
  }

  /** Made for a line: nothing wraps in it. */
  private static FieldView view(FieldViews views, Item item) {
    if (item instanceof Item.Quantity number) {
      return new NumberView(views, number, false);
    }
    return item instanceof Item.Presses presses
        ? new PressesView(views, presses, false)
        : views.view(item);
  }

  private static String width(Item item) {
    return switch (item) {
      case Item.Expression _ -> ", w 40:150, growx, pushx 200";
      case Item.Text _ -> ", w 70:110, growx, pushx 100";
      case Item.Presses _ -> ", wmin pref";
      case Item.Quantity _,
          Item.Prose _,
          Item.Code _,
          Item.Choice _,
          Item.Check _,
          Item.Note _,
          Item.Drawing _,
          Item.Grid _,
          Item.Line _ ->
          "";
    };
  }

  private static JComponent labelled(String text, FieldView view) {
    JPanel both = new JPanel(new MigLayout("insets 0, gap 4", "[][]"));
    both.setOpaque(false);
    JLabel label = new JLabel(text);
    label.setLabelFor(view.focus());
    both.add(label);
    both.add(view.component());
    return both;
  }

  /** The check that stands before the others, in the column of the labels. */
  Optional<JComponent> lead() {
    return lead;
  }

  /** The views of its items, in their order. */
  List<FieldView> views() {
    return List.copyOf(views);
  }

  @Override
  public JComponent component() {
    return row;
  }

  @Override
  public void show(Item shown) {
    List<Item> items = ((Item.Line) shown).items();
    for (int i = 0; i < views.size(); i++) {
      views.get(i).show(items.get(i));
    }
  }
}
