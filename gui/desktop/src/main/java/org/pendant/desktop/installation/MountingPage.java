package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.world.Vector3;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** Mounting page: how the base is mounted. */
final class MountingPage implements Page {
  private final Editing editing;
  private final TitledCard card = new TitledCard("mounting", text("mounting"), "[grow, fill]");
  private final PartsForm<Installation> form;
  private final MountingPicture picture = new MountingPicture();
  private final JLabel gravity = new JLabel();

  MountingPage(Editing editing) {
    this.editing = editing;
    form = new PartsForm<>("mounting", editing::whole, editing::takeWhole);
    form.in(editing.measures());
    form.wide(picture);
    form.numberRow(
        "tilt",
        text("tilt"),
        Measure.DEGREE,
        now -> now.mounting().tiltRad(),
        (before, rad) -> with(before, new BaseMounting(rad, before.mounting().rotationRad())));
    form.numberRow(
        "rotation",
        text("rotation"),
        Measure.DEGREE,
        now -> now.mounting().rotationRad(),
        (before, rad) -> with(before, new BaseMounting(before.mounting().tiltRad(), rad)));
    form.add(text("gravity"), gravity);
    form.buttons(
        preset("floor", text("mountedOnAFloor"), 0),
        preset("wall", text("mountedOnAWall"), Math.PI / 2),
        preset("ceiling", text("mountedOnACeiling"), Math.PI));
    form.note(text("tiltOfTheBaseAboutIts"));
    form.follow(
        now -> {
          picture.show(now.mounting());
          Vector3 g = now.mounting().gravityInBaseMPerS2();
          gravity.setText(
              String.format(Locale.ROOT, "[%.2f, %.2f, %.2f] m/s\u00b2", g.x(), g.y(), g.z()));
        });
    gravity.setName("mounting-gravity");
    card.add(form.component());
  }

  private static Installation with(Installation before, BaseMounting mounting) {
    return before.with(parts -> parts.mounting = mounting);
  }

  private JButton preset(String id, String tip, double tiltRad) {
    JButton button = new JButton(text(id));
    TitledCard.compact(button);
    TitledCard.named(button, "mounting-" + id, tip);
    button.addActionListener(
        event -> editing.take(parts -> parts.mounting = new BaseMounting(tiltRad, 0)));
    return button;
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
