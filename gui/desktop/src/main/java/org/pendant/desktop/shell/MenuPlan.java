package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.pendant.desktop.help.Example;

/**
 * Menu plan: which action is in which menu. A menu has at most 14 entries, so that all of it fits
 * in a small window; what comes later finds a place by how its id begins.
 */
final class MenuPlan {
  /** These are on the Program screen, and too many for a menu. */
  private static final String ON_SCREEN = "tree.add-";

  /** Where views may go; each view has a menu of its own for these. */
  static final String ARRANGE = "arrange.";

  /** The panels of the debugger, which are in a menu of their own. */
  private static final Set<String> DEBUGGER =
      Set.of("variables", "watches", "call-stack", "breakpoints");

  private MenuPlan() {}

  /** What stands in a menu. */
  sealed interface Entry {
    /**
     * One of several actions that mean the same on different screens: the first that can be done
     * now.
     */
    record One(List<String> ids) implements Entry {}

    /** All actions whose ids begin so and that stand nowhere by their whole id. */
    record Rest(String begin) implements Entry {}

    /**
     * A menu in a menu.
     *
     * @param word with which its name ends
     * @param said how the titles of its actions begin; they go without it there
     */
    record Sub(String word, String title, String said, List<Entry> entries) implements Entry {}

    /** A line between entries. */
    record Line() implements Entry {}

    /** Entries that are no actions, such as recent files. */
    record Files(String title) implements Entry {}

    /** Menus of the places that views may have, one for each view. */
    record Places(String word, String title, List<String> views) implements Entry {}
  }

  /**
   * A menu of the bar.
   *
   * @param word with which its name ends
   * @param forTrees whether it is shown for programs made of nodes only
   */
  record Menu(String word, String title, boolean forTrees, List<Entry> entries) {}

  /**
   * The menus of a window.
   *
   * @param screens the ids of its screens
   * @param panels the ids of its panels
   */
  static List<Menu> of(List<String> screens, List<String> panels) {
    return List.of(
        menu("file", text("menuFile"), file()),
        menu("edit", text("menuEdit"), edit()),
        new Menu("nodes", text("menuNodes"), true, nodes()),
        menu("go", text("menuGo"), go()),
        menu("view", text("menuView"), view(screens, panels)),
        menu("program", text("menuProgram"), program()),
        menu("debug", text("menuDebug"), debug()),
        menu("robot", text("menuRobot"), robot()),
        menu("tools", text("menuTools"), all("")),
        menu("help", text("menuHelp"), help()));
  }

  /**
   * Which actions stand where an entry has the rest: each where the start explains the most of its
   * id, whole words only.
   *
   * @param ids of all actions
   */
  static Map<Entry.Rest, List<String>> sorted(List<Menu> menus, List<String> ids) {
    List<Entry> entries = menus.stream().flatMap(menu -> flat(menu.entries())).toList();
    Set<String> named = new HashSet<>();
    List<Entry.Rest> rests = new ArrayList<>();
    for (Entry each : entries) {
      switch (each) {
        case Entry.One one -> named.addAll(one.ids());
        case Entry.Rest rest -> rests.add(rest);
        case Entry.Sub _, Entry.Line _, Entry.Files _, Entry.Places _ -> {}
      }
    }
    Map<Entry.Rest, List<String>> sorted = new HashMap<>();
    for (String id : ids) {
      if (!named.contains(id) && !id.startsWith(ON_SCREEN) && !id.startsWith(ARRANGE)) {
        rests.stream()
            .filter(rest -> fits(id, rest.begin()))
            .max(Comparator.comparingInt(rest -> rest.begin().length()))
            .ifPresent(rest -> sorted.computeIfAbsent(rest, _ -> new ArrayList<>()).add(id));
      }
    }
    return sorted;
  }

  /**
   * The actions of each menu, with those of the menus in it, by the menu's title.
   *
   * @param ids of all actions
   */
  static Map<String, List<String>> byTitle(List<Menu> menus, List<String> ids) {
    Map<Entry.Rest, List<String>> sorted = sorted(menus, ids);
    Map<String, List<String>> byTitle = new LinkedHashMap<>();
    for (Menu menu : menus) {
      byTitle.put(
          menu.title(),
          flat(menu.entries())
              .flatMap(
                  entry ->
                      switch (entry) {
                        case Entry.One one -> one.ids().stream();
                        case Entry.Rest rest -> sorted.getOrDefault(rest, List.of()).stream();
                        case Entry.Sub _, Entry.Line _, Entry.Files _, Entry.Places _ ->
                            Stream.empty();
                      })
              .toList());
    }
    return byTitle;
  }

  private static Stream<Entry> flat(List<Entry> entries) {
    return entries.stream()
        .flatMap(
            entry ->
                entry instanceof Entry.Sub sub
                    ? Stream.concat(Stream.of(entry), flat(sub.entries()))
                    : Stream.of(entry));
  }

  private static boolean fits(String id, String begin) {
    int end = begin.length();
    return end == 0
        || (id.startsWith(begin)
            && (id.length() == end || id.charAt(end) == '.' || id.charAt(end) == '-'));
  }

  private static List<Entry> file() {
    return list(
        all("file.new", "file.new-script", "file.open"),
        sub(
            "recent",
            text("recent"),
            "",
            list(all("file.recent"), line(), files(text("recentPrograms")))),
        line(),
        all("file.save", "file.save-as"),
        sub("export", text("export"), "", all("file.save-script", "file.export")),
        all("file.reload"),
        one("editor.close", "tree.close"),
        all("editor.reopen"),
        line(),
        sub(
            "installation",
            text("installationMenu"),
            "",
            list(
                all("installation.new", "installation.open"),
                sub("recent", text("recent"), "", list(files(text("recentInstallations")))),
                line(),
                all("installation.save", "installation.save-as", "installation.reload"))),
        sub(
            "scene",
            text("sceneMenu"),
            "",
            list(
                all("scene-file.new", "scene-file.open"),
                line(),
                all("scene-file.save", "scene-file.save-as", "scene-file.apply"),
                line(),
                all("cell"))),
        all("file.open-recording", "file"),
        line(),
        all("file.quit"));
  }

  private static List<Entry> edit() {
    return list(
        one("editor.undo", "tree.undo", "installation.undo", "cell.undo"),
        one("editor.redo", "tree.redo", "installation.redo", "cell.redo"),
        line(),
        all("edit.cut", "edit.copy", "edit.paste"),
        line(),
        sub(
            "find",
            text("find"),
            "",
            list(
                one("editor.find", "tree.find"),
                all("editor.replace"),
                one("editor.find-next", "tree.find-next"),
                one("editor.find-previous", "tree.find-previous"),
                all("editor.find-in-files"))),
        sub(
            "lines",
            text("lines"),
            "",
            all(
                "editor.comment",
                "editor.indent",
                "editor.outdent",
                "editor.move-up",
                "editor.move-down",
                "editor.duplicate",
                "editor.delete-line")),
        sub("fold", text("fold"), "", all("editor.fold", "editor.fold-all", "editor.unfold-all")),
        line(),
        all(
            "editor.complete",
            "editor.signature",
            "editor.quick-fix",
            "editor.rename",
            "editor.format"),
        all("edit", "editor", "script"));
  }

  private static List<Entry> nodes() {
    return list(
        all("tree.cut", "tree.copy", "tree.paste", "tree.delete"),
        line(),
        all("tree.rename", "tree.duplicate", "tree.suppress", "tree.move-up", "tree.move-down"),
        line(),
        sub("fold", text("fold"), "", all("tree.fold", "tree.fold-all", "tree.unfold-all")),
        sub(
            "go-to",
            text("goTo"),
            "",
            all("tree.palette", "tree.form", "tree.to-tree", "tree.script")),
        all("tree"));
  }

  private static List<Entry> go() {
    return list(
        all("editor.open-file", "editor.symbol", "editor.line"),
        line(),
        all("editor.definition", "editor.references"),
        line(),
        all("editor.back", "editor.forward"),
        line(),
        all("editor.next-tab", "editor.previous-tab"),
        line(),
        all("debug.show-held", "help.question", "help.notice"));
  }

  private static List<Entry> view(List<String> screens, List<String> panels) {
    return list(
        sub(
            "screens",
            text("screens"),
            text("show"),
            list(shows(screens), line(), places("move-a-screen", text("moveAScreen"), screens))),
        panels(
            panels.stream().filter(each -> !DEBUGGER.contains(each)).toList(),
            panels.stream().filter(DEBUGGER::contains).toList()),
        line(),
        sub("docks", text("docks"), "", all("dock")),
        all("view"),
        line(),
        sub(
            "3d-view",
            text("view3d"),
            "3D",
            list(
                sub(
                    "look-from",
                    text("lookFrom"),
                    text("lookFrom3d"),
                    all(
                        "scene.iso",
                        "scene.front",
                        "scene.back",
                        "scene.left",
                        "scene.right",
                        "scene.top")),
                all("scene.fit", "scene.tool"),
                sub(
                    "way-of-the-tool",
                    text("wayOfTheTool"),
                    "3D",
                    list(
                        all("scene.trace", "scene.trace-elbow", "scene.clear"),
                        line(),
                        all("scene.trace-by"))),
                line(),
                sub("safety", text("safety"), text("show3d"), all("scene.safety")),
                sub("scene", text("sceneMenu"), "", all("scene-file")),
                all("scene"))),
        sub("variables", text("variables"), text("variables"), all("variables")),
        sub("plots", text("plots"), text("plots"), all("plot")),
        sub("timeline", text("timeline"), text("timeline"), all("timeline")),
        sub("log", text("log"), text("log"), all("log")),
        line(),
        sub(
            "colours",
            text("colours"),
            text("colours"),
            all("look.light", "look.dark", "look.system")),
        sub("language", text("languageMenu"), text("languageMenu"), all("language")),
        sub(
            "size",
            text("size"),
            "",
            list(
                all("look.larger", "look.smaller", "look.normal"),
                line(),
                all("editor.larger", "editor.smaller", "editor.usual-size"))),
        sub(
            "units",
            text("units"),
            text("units"),
            list(all("unit.length"), line(), all("unit.angle"), line(), all("unit.rotation"))),
        all("look"));
  }

  private static List<Entry> panels(List<String> panels, List<String> ofDebugger) {
    return sub(
        "panels",
        text("panels"),
        text("show"),
        list(
            shows(panels),
            sub(
                "debugger",
                text("debugger"),
                text("show"),
                list(
                    shows(ofDebugger),
                    line(),
                    places("move-a-panel", text("moveAPanel"), ofDebugger))),
            line(),
            places("move-a-panel", text("moveAPanel"), panels)));
  }

  private static List<Entry> program() {
    return list(
        all("program.run", "program.run-from", "program.pause", "program.stop"),
        line(),
        all("program.answer"),
        line(),
        sub("speed", text("speed"), "", all("speed")),
        sub("waveforms", text("waveforms"), text("waveforms"), all("waveforms")),
        sub("what-if", text("whatIf"), text("whatIf"), all("whatif")),
        sub("sweep", text("sweep"), text("sweep"), all("sweep")),
        sub("tests", text("tests"), text("tests"), all("tests")),
        line(),
        all("program.ask-start"),
        one("editor.follow", "tree.follow"),
        all("program"));
  }

  private static List<Entry> debug() {
    return list(
        all(
            "program.step",
            "debug.step-into",
            "debug.step-out",
            "debug.run-to-line",
            "debug.pause",
            "debug.step-over"),
        line(),
        all("past.step-back"),
        sub("in-the-recording", text("inTheRecording"), "", all("past")),
        line(),
        one("editor.breakpoint", "tree.breakpoint"),
        all("debug.conditional-breakpoint", "debug"));
  }

  private static List<Entry> robot() {
    return list(
        all("robot.ready", "robot.off", "robot.choose", "robot.restart"),
        line(),
        sub("robot-time", text("robotTime"), "", all("clock")),
        sub("move-by-hand", text("moveByHand"), text("moveByHand"), byHand()),
        sub("installation", text("installationMenu"), text("showInstallation"), pages()),
        sub("inputs-and-registers", text("inputsAndRegisters"), "", all("io")),
        line(),
        all("robot.ports", "robot.clients", "robot.ports-switch"),
        sub("messages-of-clients", text("messagesOfClients"), "", all("clients")),
        line(),
        sub("controllers-of-the-cell", text("controllersOfTheCell"), "", all("controllers")),
        sub("simulation", text("simulation"), "", all("robot.noise", "robot.start-ramp")),
        all("robot"));
  }

  private static List<Entry> byHand() {
    return list(
        all("move.step-held", "move.step-fine", "move.step-medium", "move.step-coarse"),
        line(),
        all("move.axes-base", "move.axes-tool", "move.axes-frame"),
        line(),
        all("move.freedrive", "move.home-here", "move.frame-here"),
        line(),
        all("move"));
  }

  private static List<Entry> pages() {
    return list(
        all("installation"),
        line(),
        sub(
            "safety",
            text("safety"),
            text("showInstallation"),
            all(
                "installation.page-limits",
                "installation.page-joint-limits",
                "installation.page-planes",
                "installation.page-tool-direction")),
        sub(
            "fieldbus",
            text("fieldbus"),
            text("showInstallation"),
            all(
                "installation.page-modbus",
                "installation.page-ethernet-ip",
                "installation.page-external-control")));
  }

  private static List<Entry> help() {
    return list(
        all("help.documentation", "help.context", "help.shortcuts"),
        line(),
        sub(
            "examples",
            text("examples"),
            text("example"),
            Stream.of(Example.Topic.values())
                .<Entry>map(
                    topic ->
                        new Entry.Sub(
                            topic.name().toLowerCase(Locale.ROOT),
                            topic.title(),
                            text("example"),
                            all("example." + topic.name().toLowerCase(Locale.ROOT))))
                .toList()),
        all("help.welcome"),
        line(),
        all("help.palette", "help.keys", "help"),
        line(),
        all("help.report", "help.logs", "help.about"));
  }

  private static List<Entry> all(String... begins) {
    return Stream.of(begins).<Entry>map(Entry.Rest::new).toList();
  }

  private static List<Entry> shows(List<String> views) {
    return views.stream().<Entry>map(view -> new Entry.Rest("view." + view)).toList();
  }

  private static Menu menu(String word, String title, List<Entry> entries) {
    return new Menu(word, title, false, entries);
  }

  private static List<Entry> one(String... ids) {
    return List.of(new Entry.One(List.of(ids)));
  }

  private static List<Entry> sub(String word, String title, String said, List<Entry> entries) {
    return List.of(new Entry.Sub(word, title, said, entries));
  }

  private static List<Entry> files(String title) {
    return List.of(new Entry.Files(title));
  }

  private static List<Entry> places(String word, String title, List<String> views) {
    return List.of(new Entry.Places(word, title, views));
  }

  private static List<Entry> line() {
    return List.of(new Entry.Line());
  }

  @SafeVarargs
  @SuppressWarnings("varargs") // only read
  private static List<Entry> list(List<Entry>... parts) {
    return Stream.of(parts).flatMap(List::stream).toList();
  }
}
