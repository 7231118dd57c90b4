package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.HierarchyBoundsAdapter;
import java.awt.event.HierarchyEvent;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.FloatingPanel;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;

/**
 * Safety question: shows what changes of the safety configuration, as the arm is powered off for
 * it, and asks whether it is to change. It floats over the page, so that nothing there moves, and
 * goes away where that does.
 */
final class SafetyQuestion {
  private static final int WIDTH = 340;
  private static final int MAX_LIST_HEIGHT = 220;

  private final JComponent bar;
  private final Remark changes;
  private final JButton really = new JButton();
  private final JButton back = new JButton(text("back"));
  private final FloatingPanel panel;
  private Runnable change = () -> {};
  private Component from;

  /**
   * A question that nobody is asked yet.
   *
   * @param bar below which it floats
   * @param name with which the names of its components begin
   */
  SafetyQuestion(JComponent bar, String name) {
    this.bar = bar;
    from = bar;
    changes = new Remark(name + "-changes", Palette::warning);
    really.setName(name + "-really");
    really.addActionListener(event -> answer(change));
    TitledCard.named(back, name + "-back", text("doNotApplyThemYet"));
    back.addActionListener(event -> answer(() -> {}));
    TitledCard.compact(really, back);
    panel = new FloatingPanel(bar, content());
    bar.addHierarchyListener(
        event -> {
          if ((event.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0 && !bar.isShowing()) {
            panel.hide();
          }
        });
    bar.addHierarchyBoundsListener(
        new HierarchyBoundsAdapter() {
          @Override
          public void ancestorResized(HierarchyEvent event) {
            if (panel.visible()) {
              place();
            }
          }
        });
  }

  private JPanel content() {
    JScrollPane list =
        new JScrollPane(
            changes,
            ScrollPaneConstants.VERTICAL_SCROLLBAR_AS_NEEDED,
            ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    list.setBorder(BorderFactory.createEmptyBorder());
    list.setOpaque(false);
    list.getViewport().setOpaque(false);
    JPanel row = new JPanel(new WrappingRow(PartsForm.BETWEEN));
    row.setOpaque(false);
    row.add(really);
    row.add(back);
    JPanel content = new JPanel(new MigLayout("insets 10 12 10 12, gap 8 8, wrap", "[fill]"));
    content.setOpaque(false);
    content.add(
        list, "width " + UIScale.scale(WIDTH) + "!, hmax " + UIScale.scale(MAX_LIST_HEIGHT));
    content.add(row, "wmin 0, pad 0 -" + PartsForm.BETWEEN + " 0 0");
    content.setFocusCycleRoot(true); // Tab stays in what floats over the page
    content
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke("ESCAPE"), "back");
    content
        .getActionMap()
        .put(
            "back",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                answer(() -> {});
              }
            });
    return content;
  }

  /**
   * Asks.
   *
   * @param lines what changes, a line each
   * @param words on the button that makes the change, which powers the arm off
   * @param makes the change
   * @param asks the button that asks, which gets the keys again
   */
  void ask(List<String> lines, String words, Runnable makes, Component asks) {
    change = makes;
    from = asks;
    really.setText(words);
    really.setToolTipText(text("applyTheChangesTheArmIs"));
    changes.say(String.join("\n", lines));
    // how high it is depends on how wide it is
    changes.setSize(UIScale.scale(WIDTH), Short.MAX_VALUE);
    place();
    back.requestFocusInWindow();
  }

  /** Whether somebody is asked. */
  boolean asking() {
    return panel.visible();
  }

  /** Asks no more. */
  void close() {
    panel.hide();
  }

  private void place() {
    panel.show(new Rectangle(0, 0, bar.getWidth(), bar.getHeight()), false);
  }

  private void answer(Runnable answer) {
    panel.hide();
    from.requestFocusInWindow();
    answer.run();
  }
}
