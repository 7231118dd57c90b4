/**
 * Icons of the desktop: drawings (.svg) among the resources, coloured by the theme. Begin with
 * {@link org.pendant.kit.icon.SvgIcon}; {@link org.pendant.kit.icon.Glyph} names those that every
 * screen may use.
 */
package org.pendant.kit.icon;
