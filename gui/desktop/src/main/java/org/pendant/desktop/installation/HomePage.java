package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.List;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComponent;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.arm.Joints;

/** Home page: where home is. */
final class HomePage implements Page {
  private static final List<String> WORDS =
      List.of("base", "shoulder", "elbow", "wrist-1", "wrist-2", "wrist-3");

  private static final List<String> NAMES =
      List.of(
          text("base"),
          text("shoulder"),
          text("elbow"),
          text("wrist1"),
          text("wrist2"),
          text("wrist3"));

  private final Editing editing;
  private final TitledCard card = new TitledCard("home", text("home"), "[grow, fill]");
  private final PartsForm<Installation> form;

  HomePage(Editing editing, Supplier<ControllerState> state) {
    this.editing = editing;
    form = new PartsForm<>("home", editing::whole, editing::takeWhole);
    form.in(editing.measures());
    for (int i = 0; i < Joints.COUNT; i++) {
      int joint = i;
      form.numberRow(
          WORDS.get(i),
          NAMES.get(i),
          Measure.DEGREE,
          now -> now.homeRad().get(joint),
          (before, rad) -> with(before, before.homeRad().with(joint, rad)));
    }
    JButton here =
        button("set-to-here", text("setToHere"), text("makeThePresentJointPositionsHome"));
    here.addActionListener(
        event -> editing.take(p -> p.homeRad = state.get().arm().targetPositionRad()));
    JButton standard = button("standard", text("standard"), text("homeIsWhereARobotIs"));
    standard.addActionListener(event -> editing.take(p -> p.homeRad = BoxSetup.START_RAD));
    form.buttons(here, standard);
    form.note(text("whereTheNodeHomeAndThe"));
    card.add(form.component());
  }

  private static JButton button(String id, String title, String tip) {
    JButton button = new JButton(title);
    TitledCard.compact(button);
    return TitledCard.named(button, "home-" + id, tip);
  }

  private static Installation with(Installation before, Joints homeRad) {
    return before.with(parts -> parts.homeRad = homeRad);
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    form.show(editing.now());
  }
}
