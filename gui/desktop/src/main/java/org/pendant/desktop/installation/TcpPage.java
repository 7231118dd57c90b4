package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationParts;
import org.pendant.controller.installation.NamedTool;
import org.pendant.desktop.unit.PoseRows;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.pose.Pose;

/** TCP page: the TCPs, and the one that is active when a program starts. */
final class TcpPage implements Page {
  private final Editing editing;
  private final TitledCard card = new TitledCard("tcp", "TCP", "[grow, fill]");
  private final Items<NamedTool> items;
  private final PartsForm<Installation> active;

  TcpPage(Editing editing, RotationChoice rotation) {
    this.editing = editing;
    items =
        new Items<>(
            "tcp",
            text("tcps"),
            text("noTcpYetProgramsMoveThe"),
            new Listed<>(
                editing, Installation::tools, (parts, all) -> parts.tools = all, TcpPage::follow),
            tool -> isActive(tool) ? text("activeOne", tool.name()) : tool.name());
    items.adder("add-tcp", text("addTcp"), () -> new NamedTool(items.freshName("TCP"), Pose.ZERO));
    PartsForm<NamedTool> form = items.form().in(editing.measures());
    form.text(
        "name",
        text("name"),
        NamedTool::name,
        (before, name) -> new NamedTool(name.strip(), before.inFlange()));
    PoseRows.addTo(
        form,
        "tcp",
        rotation,
        NamedTool::inFlange,
        (before, pose) -> new NamedTool(before.name(), pose),
        now -> true);
    JButton set = new JButton(text("setTcp"));
    TitledCard.named(set, "tcp-set", text("makeThisTheActiveTcp"));
    set.addActionListener(
        event -> items.chosen().ifPresent(tool -> editing.take(p -> p.activeTool = tool.name())));
    form.buttons(set);
    form.note(text("whereTheTcpIsInThe"));
    active = new PartsForm<>("tcp-active", editing::whole, editing::takeWhole);
    active.choice(
        "active-tcp",
        text("activeTcp"),
        TcpPage::names,
        name -> name.isEmpty() ? text("noneTheFlange") : name,
        Installation::activeTool,
        (before, name) -> before.with(parts -> parts.activeTool = name));
    card.add(active.component());
    card.add(items.component());
    rotation.addListener(this::show);
  }

  private boolean isActive(NamedTool tool) {
    return tool.name().equals(editing.now().activeTool());
  }

  private static List<String> names(Installation installation) {
    List<String> names = new ArrayList<>(List.of(""));
    installation.tools().forEach(each -> names.add(each.name()));
    return names;
  }

  private static void follow(
      InstallationParts parts, Optional<NamedTool> before, Optional<NamedTool> after) {
    if (before.isPresent() && before.get().name().equals(parts.activeTool)) {
      parts.activeTool = after.map(NamedTool::name).orElse("");
    }
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    active.show(editing.now());
    items.show();
  }
}
