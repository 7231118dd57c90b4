/**
 * Timeline: what the robot did, and the moment that the other views show meanwhile. Open {@link
 * org.pendant.desktop.timeline.LookBack} first.
 */
package org.pendant.desktop.timeline;
