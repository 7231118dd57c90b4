/**
 * Units: in what people read and type lengths, angles and poses, on all screens alike. Open {@link
 * org.pendant.desktop.unit.PoseForm} first.
 */
package org.pendant.desktop.unit;
