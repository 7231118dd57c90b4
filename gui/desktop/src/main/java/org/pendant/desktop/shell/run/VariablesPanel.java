package org.pendant.desktop.shell.run;

import static org.pendant.desktop.shell.run.RunTexts.text;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.desktop.debug.Favourites;
import org.pendant.desktop.debug.HiddenNames;
import org.pendant.desktop.debug.Star;
import org.pendant.kit.form.Remark;
import org.pendant.kit.theme.Card;
import org.pendant.kit.theme.Palette;
import org.pendant.script.variables.VariableSamples;

/** Variables panel: a card with the variables of the running or last program, favourites first. */
final class VariablesPanel {
  private static final String EMPTY = text("theVariablesOfAProgramAppear");

  /** Least time between two changes of the texts, ms. */
  private static final long PERIOD_MS = 95;

  private final Favourites favourites;
  private final HiddenNames hidden;
  private final JPanel card =
      new Card(
          new MigLayout(
              "insets 16, gap 8 4, wrap 2, hidemode 3",
              "[shrinkprio 50]16[grow, fill, shrinkprio 200]",
              ""));
  private final Remark none = new Remark("run-variables-none", Palette::quiet);
  private final JButton more = new JButton();
  private final List<JLabel> names = new ArrayList<>();
  private final List<JLabel> values = new ArrayList<>();
  private VariableSamples shown = VariableSamples.NONE;
  private List<InstallationVariable> shownInstalled = List.of();
  private String program = "";
  private long shownMs;
  private boolean stale = true;

  /**
   * A card without variables.
   *
   * @param showAll shows all variables somewhere else
   */
  VariablesPanel(Favourites favourites, HiddenNames hidden, Runnable showAll) {
    this.favourites = favourites;
    this.hidden = hidden;
    hidden.addListener(() -> stale = true);
    favourites.addListener(() -> stale = true);
    card.setName("run-variables");
    card.getAccessibleContext().setAccessibleName(text("variables"));
    JLabel heading = new JLabel(text("variables"));
    heading.putClientProperty("FlatLaf.styleClass", "h4");
    none.say(EMPTY);
    more.setName("run-variables-more");
    more.putClientProperty("JButton.buttonType", "toolBarButton");
    more.setToolTipText(text("showsAllVariablesToFilterUnfold"));
    more.getAccessibleContext().setAccessibleName(text("allVariables"));
    more.addActionListener(event -> showAll.run());
    card.add(heading, "span 2, wmin 0");
    card.add(none, "span 2, " + Remark.LAYOUT);
    for (int i = 0; i < VariableFacts.MOST; i++) {
      JLabel name = new JLabel();
      name.putClientProperty("FlatLaf.styleClass", "monospaced");
      name.setHorizontalTextPosition(SwingConstants.LEADING);
      JLabel value = new JLabel();
      value.putClientProperty("FlatLaf.styleClass", "monospaced");
      value.setName("run-variable-" + i);
      names.add(name);
      values.add(value);
      card.add(name, "wmin 0");
      card.add(value, "wmin 0");
    }
    card.add(more, "span 2, wmin 0, alignx left, grow 0");
    show(new VariableFacts(List.of(), 0));
  }

  JPanel component() {
    return card;
  }

  /**
   * Shows samples.
   *
   * @param name of the program that they are of
   * @param installed variables that every program has
   */
  void refresh(String name, VariableSamples samples, List<InstallationVariable> installed) {
    long nowMs = System.nanoTime() / 1_000_000;
    boolean other = !name.equals(program) || !samples.equals(shown);
    other |= !installed.equals(shownInstalled);
    if (stale || (other && nowMs - shownMs >= PERIOD_MS)) {
      stale = false;
      shown = samples;
      shownInstalled = installed;
      program = name;
      shownMs = nowMs;
      show(
          VariableFacts.of(
              shown, favourites.of(program), each -> hidden.hides(program, each), installed));
    }
  }

  private void show(VariableFacts facts) {
    none.setVisible(facts.rows().isEmpty());
    for (int i = 0; i < VariableFacts.MOST; i++) {
      boolean used = i < facts.rows().size();
      names.get(i).setVisible(used);
      values.get(i).setVisible(used);
      if (used) {
        show(i, facts.rows().get(i));
      }
    }
    more.setVisible(!facts.rows().isEmpty());
    more.setText(facts.more() > 0 ? text("more", facts.more()) : text("allVariablesMore"));
  }

  private void show(int place, VariableFacts.Row row) {
    JLabel name = names.get(place);
    if (!row.name().equals(name.getText()) || row.favourite() != (name.getIcon() != null)) {
      name.setText(row.name());
      String what = row.favourite() ? text("favourite", row.name()) : row.name();
      name.setToolTipText(row.installed() ? text("keptByTheInstallation", what) : what);
      name.setIcon(row.favourite() ? Star.of(true) : null);
    }
    JLabel value = values.get(place);
    if (!row.value().equals(value.getText())) {
      value.setText(row.value());
      value.setToolTipText(row.value());
      value.getAccessibleContext().setAccessibleDescription(text("valueOf", row.name()));
    }
  }
}
