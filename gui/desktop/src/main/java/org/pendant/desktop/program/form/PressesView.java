package org.pendant.desktop.program.form;

import com.formdev.flatlaf.util.UIScale;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.HoldButton;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;

/** Button view: buttons beside each other. */
final class PressesView implements FieldView {
  /** Between buttons, in pixels before scaling. */
  static final int GAP = 4;

  private final JPanel row;
  private final List<JButton> buttons = new ArrayList<>();
  private Item.Presses item;

  /**
   * Buttons.
   *
   * @param wrapping whether they may stand below each other where it is narrow
   */
  PressesView(FieldViews views, Item.Presses presses, boolean wrapping) {
    item = presses;
    row = new JPanel(wrapping ? new WrappingRow(GAP) : new MigLayout("insets 0, gap " + GAP));
    if (wrapping) {
      bare(row);
    }
    row.setOpaque(false);
    row.setName(views.id(presses.name()));
    for (int i = 0; i < presses.buttons().size(); i++) {
      int index = i;
      Item.Press press = presses.buttons().get(i);
      JButton button;
      if (press.release().isPresent()) {
        button =
            new HoldButton(
                press.text(),
                null,
                () -> now(index).press().run(),
                () -> now(index).release().ifPresent(Runnable::run));
      } else {
        button = new JButton(press.text());
        button.addActionListener(
            event -> {
              now(index).press().run();
              views.done().run();
            });
      }
      TitledCard.compact(button);
      TitledCard.named(button, views.id(press.name()), press.tip());
      buttons.add(button);
      row.add(button);
    }
    show(presses);
  }

  /** A row without space around it. */
  static void bare(JPanel row) {
    row.setOpaque(false);
    int around = UIScale.scale(-GAP);
    row.setBorder(BorderFactory.createEmptyBorder(around, around, around, around));
  }

  private Item.Press now(int index) {
    return item.buttons().get(index);
  }

  @Override
  public JComponent component() {
    return row;
  }

  @Override
  public void show(Item shown) {
    item = (Item.Presses) shown;
    for (int i = 0; i < buttons.size(); i++) {
      buttons.get(i).setEnabled(now(i).enabled());
      buttons.get(i).setToolTipText(now(i).tip());
    }
  }
}
