/**
 * Settings that are remembered from one start to the next, and where. Open {@link
 * org.pendant.kit.settings.Settings} first.
 */
package org.pendant.kit.settings;
