/**
 * Action search: finding and rebinding actions. Open {@link org.pendant.kit.find.CommandPalette}
 * first.
 */
package org.pendant.kit.find;
