package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.Optional;
import javax.swing.JComponent;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;

/** Load card: what truly hangs on the flange, and what pushes the tool. */
final class LoadCard {
  private final SceneDraft draft;
  private final TitledCard card =
      new TitledCard("on-the-flange", text("onTheFlange"), "[grow, fill]");
  private final PartsForm<Scene> form;

  /**
   * @param measures in which lengths are shown
   */
  LoadCard(SceneDraft draft, Measures measures) {
    this.draft = draft;
    form =
        new PartsForm<Scene>("cell-load", this::refusal, draft::set)
            .in(measures)
            .telling(why -> ShownRange.of(why, measures));
    form.check(
        "a-load-hangs-there",
        text("aLoadHangsThere"),
        now -> now.load().isPresent(),
        (scene, on) -> with(scene, on ? Optional.of(Payload.of(1, 0, 0, 0)) : Optional.empty()));
    form.section(
        now -> now.load().isPresent(),
        () -> {
          form.numberRow(
              "mass",
              text("mass"),
              Measure.KILOGRAM,
              now -> load(now).massKg(),
              (scene, kg) -> with(scene, changed(load(scene), kg, cogM(scene))));
          form.heading(text("centreOfGravityInTheFlange"));
          Axes.addTo(
              form,
              "centre",
              text("centre"),
              Measure.MILLIMETRE,
              LoadCard::cogM,
              (scene, cogM) -> with(scene, changed(load(scene), load(scene).massKg(), cogM)));
        });
    form.heading(text("whatPushesTheToolAlongThe"));
    Axes.addTo(
        form,
        "force",
        text("force"),
        Measure.NEWTON,
        now -> new Vector3(push(now).fx(), push(now).fy(), push(now).fz()),
        (scene, force) ->
            pushed(
                scene,
                new Wrench(
                    force.x(),
                    force.y(),
                    force.z(),
                    push(scene).mx(),
                    push(scene).my(),
                    push(scene).mz())));
    Axes.addTo(
        form,
        "torque",
        text("torque"),
        Measure.NEWTON_METRE,
        now -> new Vector3(push(now).mx(), push(now).my(), push(now).mz()),
        (scene, torque) ->
            pushed(
                scene,
                new Wrench(
                    push(scene).fx(),
                    push(scene).fy(),
                    push(scene).fz(),
                    torque.x(),
                    torque.y(),
                    torque.z())));
    card.add(form.component());
  }

  private static Payload load(Scene scene) {
    return scene.load().orElse(Payload.NONE);
  }

  private static Vector3 cogM(Scene scene) {
    Payload load = load(scene);
    return new Vector3(load.cogXM(), load.cogYM(), load.cogZM());
  }

  private static Wrench push(Scene scene) {
    return scene.pushAtTcpInBase();
  }

  private static Optional<Payload> changed(Payload load, double massKg, Vector3 cogM) {
    return Optional.of(
        new Payload(
            massKg,
            cogM.x(),
            cogM.y(),
            cogM.z(),
            load.ixx(),
            load.iyy(),
            load.izz(),
            load.ixy(),
            load.ixz(),
            load.iyz()));
  }

  private static Scene with(Scene scene, Optional<Payload> load) {
    return scene.withLoad(load);
  }

  private static Scene pushed(Scene scene, Wrench push) {
    return scene.withPush(push);
  }

  private String refusal(Scene next) {
    return SceneRefusal.of(() -> next, draft, draft.equipment());
  }

  JComponent component() {
    return card;
  }

  /** Shows the draft. */
  void show() {
    form.show(draft.scene());
  }
}
