package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.command.CollisionWatcher.Collision;
import org.pendant.command.CollisionWatcher.Nearest;
import org.pendant.controller.world.LinkHit;
import org.pendant.language.source.Source;
import org.pendant.models.json.JsonValues;

/**
 * Collision report: what the arm of a program got into, for people and as JSON.
 *
 * @param controller what the cell calls the controller of the program; empty where there is one
 */
record CollisionReport(
    RunnableFile file, Source source, Optional<String> controller, CollisionWatcher watcher) {
  private static final double MM = 1000;

  /** Says that the program went on after it had been watched for so long. */
  void tellLimit(double limitS, Console console) {
    console.complain(Report.note(source, text("lookedAtFirst", limitS)));
  }

  /** Tells each collision with its line, or else what came nearest. */
  void tell(Console console) {
    for (Collision each : watcher.collisions()) {
      String node = file.nodeAt(each.line()).map(place -> " (" + place + ")").orElse("");
      console.complain(
          text(
              "collision",
              source.name(),
              each.line(),
              each.hit().sentence(),
              each.other()
                  .map(other -> " (" + other.program() + ":" + other.line() + ")")
                  .orElse(""),
              seconds(each.timeS()),
              millimetres(each.hit().depthM()),
              seconds(each.untilS()),
              node));
    }
    Optional<Nearest> nearest = watcher.nearest();
    if (watcher.collisions().isEmpty() && nearest.isPresent()) {
      console.complain(Report.note(source, nearest(nearest.get())));
    }
  }

  private static String nearest(Nearest found) {
    LinkHit pair = found.pair();
    String key =
        pair.object()
            ? "nearestIsObject"
            : pair.otherArm().isPresent() ? "nearestIsOtherArm" : "nearestIsLink";
    return text(
        key,
        pair.link(),
        pair.other(),
        pair.otherArm().orElse(""),
        millimetres(-pair.depthM()),
        seconds(found.timeS()),
        found.line());
  }

  /** As a member of a list in JSON. */
  String json() {
    String collisions =
        watcher.collisions().stream()
            .map(
                each ->
                    "        {%s, \"depth\": %s, \"line\": %d%s, \"time\": %s, \"until\": %s}"
                        .formatted(
                            json(each.hit()),
                            JsonValues.number(each.hit().depthM()),
                            each.line(),
                            each.other().map(other -> ", \"arm_line\": " + other.line()).orElse(""),
                            JsonValues.number(each.timeS()),
                            JsonValues.number(each.untilS())))
            .collect(Collectors.joining(",\n"));
    String nearest =
        watcher
            .nearest()
            .map(
                each ->
                    ",\n      \"nearest\": {%s, \"distance\": %s, \"line\": %d, \"time\": %s}"
                        .formatted(
                            json(each.pair()),
                            JsonValues.number(-each.pair().depthM()),
                            each.line(),
                            JsonValues.number(each.timeS())))
            .orElse("");
    return "    {\n      %s\"program\": %s,\n      \"seconds\": %s,\n      \"collisions\": [%s]%s\n    }"
        .formatted(
            controller
                .map(name -> "\"controller\": " + JsonValues.text(name) + ",\n      ")
                .orElse(""),
            JsonValues.text(file.file()),
            JsonValues.number(watcher.timeS()),
            collisions.isEmpty() ? "" : "\n" + collisions + "\n      ",
            nearest);
  }

  private static String json(LinkHit pair) {
    return "\"link\": %s, \"%s\": %s%s"
        .formatted(
            JsonValues.text(pair.link()),
            pair.object() ? "object" : "other_link",
            JsonValues.text(pair.other()),
            pair.otherArm().map(arm -> ", \"arm\": " + JsonValues.text(arm)).orElse(""));
  }

  private static String seconds(double seconds) {
    return String.format(Locale.ROOT, "%.3f", seconds);
  }

  private static String millimetres(double metres) {
    return String.format(Locale.ROOT, "%.1f", MM * metres);
  }
}
