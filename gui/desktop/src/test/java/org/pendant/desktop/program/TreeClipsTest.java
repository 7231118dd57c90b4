package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.pendant.desktop.program.Trees.MAIN;
import static org.pendant.desktop.program.Trees.move;
import static org.pendant.desktop.program.Trees.place;
import static org.pendant.desktop.program.Trees.shown;
import static org.pendant.desktop.program.Trees.waypoint;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.text.Clip;
import org.pendant.project.program.text.ProgramText;

final class TreeClipsTest {
  private final ProgramTree from =
      Trees.of(move(waypoint("W"), waypoint("V")))
          .withWaypoint("W", place(1))
          .withWaypoint("V", place(2))
          .withWaypoint("Other", place(3));

  private Clip clip() {
    return ProgramText.readClip(TreeClips.write(from, from.childrenOf(MAIN))).orElseThrow();
  }

  @Test
  void takesTheNodesPlacesAlong() {
    assertEquals(List.of("W", "V"), List.copyOf(clip().waypoints().keySet()));
    ProgramTree to = TreeClips.paste(Trees.of(), clip(), new Spot(MAIN, 0));
    assertEquals("MoveJ .W .V", shown(to));
    assertEquals(place(2), to.waypoints().get("V"));
  }

  @Test
  void sharesPlacesThatAreTheSame() {
    ProgramTree to = TreeClips.paste(from, clip(), new Spot(MAIN, 1));
    assertEquals("MoveJ .W .V MoveJ .W .V", shown(to));
    assertEquals(from.waypoints(), to.waypoints());
  }

  @Test
  void renamesPlacesThatMeanSomewhereElse() {
    ProgramTree other = Trees.of(move(waypoint("W"))).withWaypoint("W", place(9));
    ProgramTree to = TreeClips.paste(other, clip(), new Spot(MAIN, 1));
    assertEquals("MoveJ .W MoveJ .W_1 .V", shown(to));
    assertEquals(place(9), to.waypoints().get("W"));
    assertEquals(place(1), to.waypoints().get("W_1"));
  }
}
