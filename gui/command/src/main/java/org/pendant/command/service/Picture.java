package org.pendant.command.service;

import org.pendant.controller.state.ArmState;
import org.pendant.controller.world.Scene;

/**
 * Picture of an arm in its world.
 *
 * @param robotId which arm it is
 * @param arm where it stands
 * @param world objects around it
 * @param view from where it is seen
 * @param dark whether the colours are those of the dark theme
 * @param widthPx width, pixels
 * @param heightPx height, pixels
 */
public record Picture(
    String robotId,
    ArmState arm,
    Scene world,
    StandardView view,
    boolean dark,
    int widthPx,
    int heightPx) {}
