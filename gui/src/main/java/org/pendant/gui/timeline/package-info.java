/**
 * Looking at what the robot did: the timeline, and the moment that the other views show meanwhile.
 * Open {@link org.pendant.gui.timeline.LookBack} first.
 */
package org.pendant.gui.timeline;
