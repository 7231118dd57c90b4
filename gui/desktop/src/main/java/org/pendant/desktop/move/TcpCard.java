package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.List;
import java.util.Objects;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.Remark;
import org.pendant.kit.form.RemarkSpace;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;

/** TCP card: the active TCP, and those that are kept by name. */
final class TcpCard {
  private static final String CHOOSE = text("keptTcps");

  private final MovePresenter presenter;
  private final TitledCard card =
      new TitledCard("tcp-in-the-flange", text("tcpInTheFlange"), "[grow, fill]");
  private final PoseFields fields;
  private final JComboBox<String> kept = new JComboBox<>();
  private final JTextField name = new JTextField(10);
  private final Remark problem = new Remark("move-tcp-problem", Palette::error);
  private final JButton set = new JButton(text("setTcp"));
  private final JButton reset = new JButton(text("discard"));
  private final JButton keep = new JButton(text("keep"));
  private final JButton forget = new JButton(text("forget"));
  private List<String> shownNames = List.of();
  private String activeName = "";
  private String keepProblem = "";
  private boolean filling;

  TcpCard(MovePresenter presenter) {
    this.presenter = presenter;
    ToolPresenter tool = presenter.tool();
    fields = new PoseFields(tool.tcp(), "move-tcp-", text("tcpInTheFlange"));
    TitledCard.named(name, "move-tcp-name", text("nameOfTheTcp"));
    name.getDocument().addDocumentListener(new Typed(() -> keepProblem = ""));
    TitledCard.named(kept, "move-tcp-kept", text("showATcpThatIsKept"));
    kept.addActionListener(event -> choose());
    TitledCard.named(set, "move-set-tcp", text("makeThisTheActiveTcp"));
    set.addActionListener(event -> tool.setTcp(name.getText().strip()));
    TitledCard.named(reset, "move-reset-tcp", text("forgetWhatYouHaveTyped"));
    reset.addActionListener(event -> reset());
    TitledCard.named(keep, "move-keep-tcp", text("keepThisTcpUnderItsName"));
    keep.addActionListener(event -> keepProblem = tool.keep(name.getText().strip()));
    TitledCard.named(forget, "move-forget-tcp", text("noLongerKeepTheTcpOf"));
    forget.addActionListener(event -> tool.named().forget(name.getText().strip()));
    card.add(names(), "grow");
    card.add(fields.component(), "grow, gaptop 4");
    card.add(new RemarkSpace(1, problem), Remark.LAYOUT);
    card.add(buttons(), "grow, gaptop 4");
    showNames(List.of());
  }

  private JComponent names() {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8", "[][grow, fill][fill]"));
    row.setOpaque(false);
    JLabel label = new JLabel(text("name"));
    label.setLabelFor(name);
    row.add(label);
    row.add(name, "wmin 60");
    row.add(kept, "w 110::160");
    return row;
  }

  private JComponent buttons() {
    TitledCard.compact(set, reset, keep, forget);
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8", "[][][grow][][]"));
    row.setOpaque(false);
    row.add(set);
    row.add(reset, "skip 0");
    row.add(keep, "cell 3 0");
    row.add(forget, "cell 4 0");
    return row;
  }

  JComponent component() {
    return card;
  }

  private void choose() {
    if (!filling && kept.getSelectedIndex() > 0) {
      String wanted = kept.getItemAt(kept.getSelectedIndex());
      name.setText(wanted);
      presenter.tool().choose(wanted);
      kept.setSelectedIndex(0);
    }
  }

  private void reset() {
    keepProblem = "";
    presenter.tool().resetTcp();
    name.setText(activeName);
  }

  private void showNames(List<String> names) {
    filling = true;
    shownNames = names;
    DefaultComboBoxModel<String> model = new DefaultComboBoxModel<>();
    model.addElement(CHOOSE);
    names.forEach(model::addElement);
    kept.setModel(model);
    kept.setEnabled(!names.isEmpty());
    filling = false;
  }

  void refresh() {
    ToolPresenter tool = presenter.tool();
    List<String> names = tool.named().names();
    if (!names.equals(shownNames)) {
      showNames(names);
    }
    if (!Objects.equals(activeName, tool.tcpName())) {
      activeName = tool.tcpName();
      if (!tool.tcp().edited()) {
        name.setText(activeName);
      }
    }
    fields.refresh(presenter.form());
    problem.say(problemText(tool));
    boolean renamed = !name.getText().strip().equals(activeName);
    set.setEnabled((tool.tcp().edited() || renamed) && tool.tcp().valid());
    reset.setEnabled(tool.tcp().edited() || renamed || !problem.getText().isEmpty());
    keep.setEnabled(tool.tcp().valid());
    forget.setEnabled(tool.named().find(name.getText().strip()).isPresent());
  }

  private String problemText(ToolPresenter tool) {
    String typed = fields.problem(presenter.form());
    if (typed.isEmpty()) {
      typed = tool.tcpProblem();
    }
    return typed.isEmpty() ? keepProblem : typed;
  }
}
