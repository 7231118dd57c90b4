package org.pendant.gui.move;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.gui.layout.Card;
import org.pendant.gui.workbench.Palette;

/** What is on the flange: the TCP, and the payload. */
final class ToolCard {
  private static final List<String> PAYLOAD =
      List.of("Mass", "Centre of gravity X", "Centre of gravity Y", "Centre of gravity Z");

  private final MovePresenter presenter;
  private final Card card = new Card("TCP and payload", "[grow, fill]");
  private final PoseFields tcp;
  private final JLabel name = new JLabel();
  private final List<NumberField> payload = new ArrayList<>();
  private final List<JLabel> units = new ArrayList<>();
  private final Remark tcpProblem = new Remark("move-tcp-problem", Palette::error);
  private final Remark payloadProblem = new Remark("move-payload-problem", Palette::error);
  private final JButton setTcp = new JButton("Set TCP");
  private final JButton resetTcp = new JButton("Discard");
  private final JButton setPayload = new JButton("Set payload");
  private final JButton resetPayload = new JButton("Discard");

  ToolCard(MovePresenter presenter) {
    this.presenter = presenter;
    ToolPresenter tool = presenter.tool();
    tcp = new PoseFields(tool.tcp(), "move-tcp-", "TCP in the flange");
    name.setName("move-tcp-name");
    card.add(name, "grow");
    card.add(tcp.component(), "grow");
    card.add(tcpProblem, Remark.LAYOUT);
    card.add(
        buttons(
            Card.named(setTcp, "move-set-tcp", "Make this the active TCP"),
            Card.named(resetTcp, "move-reset-tcp", "Forget what you have typed")),
        "grow, gaptop 4");
    setTcp.addActionListener(event -> tool.setTcp());
    resetTcp.addActionListener(event -> tool.resetTcp());
    card.add(new JLabel("Payload: mass, and centre of gravity in the flange"), "gaptop 12");
    card.add(payloadFields(), "grow");
    card.add(payloadProblem, Remark.LAYOUT);
    card.add(
        buttons(
            Card.named(
                setPayload, "move-set-payload", "Declare this payload; zeroes the force sensor"),
            Card.named(resetPayload, "move-reset-payload", "Forget what you have typed")),
        "grow, gaptop 4");
    setPayload.addActionListener(event -> tool.setPayload());
    resetPayload.addActionListener(event -> tool.resetPayload());
  }

  JComponent component() {
    return card;
  }

  private JComponent payloadFields() {
    JPanel panel =
        new JPanel(new MigLayout("insets 0, gap 8 4", "[]8[grow, fill]4[]24[]8[grow, fill]4[]"));
    panel.setOpaque(false);
    for (int i = 0; i < PAYLOAD.size(); i++) {
      NumberField field =
          new NumberField(
              presenter.tool().payload(), i, "move-payload-" + "mxyz".charAt(i), PAYLOAD.get(i));
      payload.add(field);
      JLabel label = new JLabel(i == 0 ? "Mass" : String.valueOf("XYZ".charAt(i - 1)));
      label.setLabelFor(field);
      units.add(new JLabel());
      int column = i == 0 ? 0 : 3;
      int row = Math.max(0, i - 1);
      panel.add(label, "cell " + column + " " + row);
      panel.add(field, "cell " + (column + 1) + " " + row + ", wmin 72");
      panel.add(units.get(i), "cell " + (column + 2) + " " + row);
    }
    return panel;
  }

  private static JComponent buttons(JButton set, JButton reset) {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8", "[][]"));
    row.setOpaque(false);
    row.add(set);
    row.add(reset);
    return row;
  }

  void refresh() {
    ToolPresenter tool = presenter.tool();
    name.setText(
        tool.tcpName().isEmpty()
            ? "Active TCP, in the flange"
            : "Active TCP " + tool.tcpName() + ", in the flange");
    tcp.refresh(presenter.form());
    for (int i = 0; i < payload.size(); i++) {
      payload.get(i).refresh();
      units.get(i).setText(tool.payload().unit(i).symbol());
    }
    String typed = tcp.problem(presenter.form());
    tcpProblem.say(typed.isEmpty() ? tool.tcpProblem() : typed);
    payloadProblem.say(tool.payloadProblem());
    setTcp.setEnabled(tool.tcp().edited() && tool.tcp().valid());
    resetTcp.setEnabled(tool.tcp().edited());
    setPayload.setEnabled(tool.payload().edited() && tool.payload().valid());
    resetPayload.setEnabled(tool.payload().edited());
  }
}
