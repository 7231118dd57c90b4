package org.pendant.kit.find;

import static org.pendant.kit.find.FindTexts.text;

import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.DefaultListModel;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.FuzzyMatch;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Overlay;
import org.pendant.kit.theme.Palette;

/**
 * Command palette: finds an action by a few letters and does it. It closes when people go on with
 * something beside it.
 */
public final class CommandPalette {
  private final ActionTable actions;
  private final Overlay overlay;
  private final JTextField query = new JTextField(40);
  private final DefaultListModel<Action> model = new DefaultListModel<>();
  private final JList<Action> list = new JList<>(model);
  private final JLabel nothing = new JLabel(text("nothingMatches"));

  /**
   * A palette that is closed.
   *
   * @param under what it may cover
   */
  public CommandPalette(ActionTable actions, JComponent under) {
    this.actions = actions;
    JPanel panel = new JPanel(new MigLayout("insets 0, gap 8, wrap 1", "[grow, fill, 0:480:]", ""));
    panel.setOpaque(false);
    query.setName("palette-query");
    query.putClientProperty("JTextField.placeholderText", text("whatDoYouWantToDo"));
    query.putClientProperty("JTextField.showClearButton", true);
    query.setToolTipText(text("aFewLettersOfAnAction"));
    query.getAccessibleContext().setAccessibleName(text("findAnAction"));
    list.setName("palette-list");
    list.setToolTipText(text("enterOrAClickDoesThe"));
    list.getAccessibleContext().setAccessibleName(text("actionsThatMatch"));
    list.setVisibleRowCount(12);
    list.setFocusable(false);
    list.setCellRenderer(new PaletteRow(actions));
    panel.add(query);
    panel.add(new JScrollPane(list), "grow, push");
    panel.add(nothing, "hidemode 3");
    overlay = new Overlay("palette", under, panel);
    query.getDocument().addDocumentListener(new Typed(this::filter));
    key("UP", () -> move(-1));
    key("DOWN", () -> move(1));
    key("PAGE_UP", () -> move(-10));
    key("PAGE_DOWN", () -> move(10));
    query.addActionListener(event -> run());
    query.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            // to something beside it; another window that comes to the front leaves it open
            if (!event.isTemporary()) {
              overlay.close();
            }
          }
        });
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            run();
          }
        });
  }

  private void key(String keys, Runnable run) {
    query.getInputMap().put(KeyStroke.getKeyStroke(keys), keys);
    query
        .getActionMap()
        .put(
            keys,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                run.run();
              }
            });
  }

  /** Opens it with all actions. */
  public void open() {
    nothing.setForeground(Palette.quiet());
    query.setText("");
    filter();
    overlay.open();
    overlay.bringToFront();
    query.requestFocusInWindow();
  }

  private void filter() {
    List<Action> found =
        FuzzyMatch.filter(
            query.getText(),
            actions.all(),
            Action::found,
            action -> action.enabled().getAsBoolean());
    model.clear();
    model.addAll(found);
    nothing.setVisible(found.isEmpty());
    move(0);
  }

  private void move(int steps) {
    if (model.isEmpty()) {
      return;
    }
    int index = Math.clamp((long) list.getSelectedIndex() + steps, 0, model.size() - 1);
    list.setSelectedIndex(index);
    list.ensureIndexIsVisible(index);
  }

  private void run() {
    Action chosen = list.getSelectedValue();
    if (chosen != null && chosen.enabled().getAsBoolean()) {
      overlay.close();
      SwingUtilities.invokeLater(() -> actions.run(chosen.id()));
    }
  }
}
