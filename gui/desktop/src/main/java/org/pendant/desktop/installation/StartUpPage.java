package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.StartUp;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.arm.ArmLibrary;

/**
 * Start-up page: what happens by itself when the robot is switched on, and which robot it is for.
 */
final class StartUpPage implements Page {
  private static final List<String> INPUTS = inputs();

  private final Editing editing;
  private final TitledCard card = new TitledCard("start-up", text("startUp"), "[grow, fill]");
  private final PartsForm<Installation> form;

  StartUpPage(Editing editing) {
    this.editing = editing;
    form = new PartsForm<>("start-up", editing::whole, editing::takeWhole);
    form.text(
            "load-program",
            text("loadProgram"),
            now -> now.startUp().program(),
            (before, name) ->
                with(
                    before,
                    s ->
                        new StartUp(
                            name.strip(),
                            s.startInput(),
                            s.startOnHigh(),
                            s.powerInput(),
                            s.powerOnHigh())))
        .note(text("theFileInTheProgramsFolder"))
        .<String>choice(
            "start-program-by",
            text("startProgramBy"),
            now -> INPUTS,
            StartUpPage::words,
            now -> now.startUp().startInput(),
            (before, input) ->
                with(
                    before,
                    s ->
                        new StartUp(
                            s.program(), input, s.startOnHigh(), s.powerInput(), s.powerOnHigh())))
        .<Boolean>choice(
            "start-on",
            text("startOn"),
            now -> List.of(true, false),
            StartUpPage::edge,
            now -> now.startUp().startOnHigh(),
            (before, high) ->
                with(
                    before,
                    s ->
                        new StartUp(
                            s.program(), s.startInput(), high, s.powerInput(), s.powerOnHigh())))
        .<String>choice(
            "switch-arm-on-by",
            text("switchArmOnBy"),
            now -> INPUTS,
            StartUpPage::words,
            now -> now.startUp().powerInput(),
            (before, input) ->
                with(
                    before,
                    s ->
                        new StartUp(
                            s.program(), s.startInput(), s.startOnHigh(), input, s.powerOnHigh())))
        .<Boolean>choice(
            "switch-on-at",
            text("switchOnAt"),
            now -> List.of(true, false),
            StartUpPage::edge,
            now -> now.startUp().powerOnHigh(),
            (before, high) ->
                with(
                    before,
                    s ->
                        new StartUp(
                            s.program(), s.startInput(), s.startOnHigh(), s.powerInput(), high)))
        .heading(text("robot"))
        .<String>choice(
            "made-for",
            text("madeFor"),
            now -> robots(),
            id -> id.isEmpty() ? text("anyRobot") : "UR" + id.substring(2),
            Installation::robot,
            (before, id) -> before.with(parts -> parts.robot = id))
        .<Double>choice(
            "safety-transition",
            text("safetyTransition"),
            now -> List.of(0.0, 1.0),
            hard -> hard == 0 ? text("hard") : text("soft"),
            Installation::transitionHardness,
            (before, hard) -> before.with(parts -> parts.transitionHardness = hard));
    card.add(form.component());
  }

  /** Changes the start-up of an installation. */
  private interface Change {
    StartUp of(StartUp before);
  }

  private static Installation with(Installation before, Change change) {
    return before.with(parts -> parts.startUp = change.of(parts.startUp));
  }

  private static String words(String input) {
    return input.isEmpty() ? text("noInput") : input;
  }

  private static String edge(boolean high) {
    return high ? text("risingEdge") : text("fallingEdge");
  }

  private static List<String> inputs() {
    List<String> names = new ArrayList<>(List.of(""));
    for (SignalBank bank : SignalBank.values()) {
      for (int i = 0; bank.input() && i < bank.size(); i++) {
        names.add(new Signal(bank, i).toString());
      }
    }
    return List.copyOf(names);
  }

  private static List<String> robots() {
    List<String> ids = new ArrayList<>(List.of(""));
    ids.addAll(ArmLibrary.ids());
    return ids;
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
