ui-templates = Açı şablonu
ui-mixed = { $setting } (karışık)
    .angles = kaydırıcı ilk açıyı, ötekileri de aynı miktarda döndürür
    .numbers = kaydırıcı en büyük sayıyı ayarlar, ötekilerin ona oranı değişmez
    .note = <b>karışık</b>: { $what }.
ui-range = { $low } ile { $high } arası

key-ctrl = Ctrl
key-shift = Shift
key-space = Boşluk
key-esc = Esc
key-delete = Delete
key-backspace = Backspace
key-tab = Tab
key-or = { $one } veya { $other }
key-too = { $text } ({ $key })
key-of = { $keys } tuşu
    .held = { $keys } tuşu, basılı tutarak

ui-panel = Kontroller
    .hide = Paneli gizle
    .show = Paneli göster
    .down = Kontrolleri gizle
    .up = Kontrolleri göster
ui-scene = { $title }: başka sahne seç
ui-close = Kapat
ui-progress = Tamamlanan kısım
ui-on = açık
    .off = kapalı
ui-plot-time = zaman, s
ui-plot-said = { $label }: şimdi { $now }; en küçük { $low }, { $lowAt } s anında; en büyük { $high }, { $highAt } s anında.
ui-plot-over = { $label }: şimdi { $now }; en küçük { $low }, { $across } { $lowAt } iken; en büyük { $high }, { $highAt } iken.
ui-plot-level = { $label }: hep { $now }.
ui-plot-none = { $label }: henüz değer yok.
ui-plot-keys = Sol ve sağ oklar zamanın başka bir bölümünü, yukarı ve aşağı oklar daha kısa veya daha uzun bir bölümünü, Home tuşu tümünü gösterir
ui-plot-numbers = Sayılar
    .caption = Görünen sayılardan eşit aralıklı { $count } tanesi; yenileri için kapatıp aç

ui-found = Bulunanlar
    .none = Bu adda bir şey yok. Bir kütleye, yaya veya ekleme ait olanlar, biri seçilince bulunur.

ui-number-unclear = { $written } iki anlama gelebilir: { $one } veya { $other }. Bunlardan birini yaz.
ui-number-none = “{ $written }” bir sayı değil. Sayıyı 20000, 2e4 veya 0,05 gibi yaz.
ui-number-least = En az { $least }.
ui-number-most = En çok { $most }.
ui-number-sign = İşareti değiştir

ui-away = Bağlı değil: cismin bekliyor. Yeniden bağlanılıyor…
ui-blocked = Sayfa yüklendi, ama canlı bağlantısı kurulamıyor: yolda bir şey WebSocket bağlantılarını engelliyor. Başka bir ağ dene, örneğin softrod programının çalıştığı bilgisayarın mobil erişim noktasını.
ui-loading = Yükleniyor…
    .later = Yavaş bir ağda ilk yükleme yarım dakikaya kadar sürebilir.
ui-needs-javascript = softrod için JavaScript gerekli; burada kapalı.
ui-needs-webgl = softrod, WebGL 2 ile çizer; bu tarayıcıda WebGL 2 yok veya kapalı: ayarlarından donanım hızlandırmaya izin ver veya başka bir tarayıcı kullan.
ui-other-viser = Bu sayfa çizim yapamıyor: viser sayfası, softrod programının desteklediği sürümde değil.
ui-not-loaded = Sayfa eksik yüklendi:
ui-no-canvas = Tarayıcı bu sayfayı artık çizmiyor. Cismin kaydedildi:
    .reload = Yeniden yükle

ui-pad = Ok tuşları
    .up = Yukarı
    .left = Sol
    .down = Aşağı
    .right = Sağ

ui-body = { $count } kütleli cisim
ui-mass = kütle { $mass }; { $place }
    .first = kütle { $mass }; { $place }. Oklar seçer, boşluk tuşu tutar
    .tools = kütle { $mass }; { $place }. Oklar seçer, Enter aracın yaptığını yapar, + kütle ekler, X bir artıyı hareket ettirir
    .held = kütle { $mass } elde. Oklar hareket ettirir
    .free = kütle { $mass } bırakıldı
    .none = kütle yok
ui-place = x { $x }, y { $y } { $unit }
ui-opened = { $title } açıldı
ui-exploded = Cisim patladı ve durduruldu
ui-running = Hareket ediyor
    .paused = Duraklatıldı
ui-broken = { $count ->
    [0] Kopan yay yok
   *[other] { $count } yay koptu
}

ui-too-much = Bir anda çok fazla istek
    .text = Son istekler dikkate alınmadı. Biraz sonra yeniden dene.
ui-stopped = Bu sayfa durdu
    .text = Sunucuda bir hata oldu. Devam etmek için sayfayı yeniden yükle.
ui-undo-afresh = Geri alma baştan başlıyor
    .text = Bağlantı kopmadan önce değiştirilenler artık geri alınamaz.
ui-commas = Ondalık virgül
    .hint = kaydedilen tablolarda 0.5 yerine 0,5 yazılır, sütunlar noktalı virgülle ayrılır

ui-no-preset = şu adda bir hazır sahne yok: { $name }; galeriden birini seç
ui-no-user = sayfa kime ait olduğunu bildirmedi; yeniden yükleyip bir daha dene
ui-no-room = burada { $count } sahnen var, daha fazlası olmaz; önce birkaçını sil
    .computer = bu bilgisayarda ziyaretçilerin başka sahnelerine yer yok; sahneyi dosya olarak indir

ui-tab-play = Dene
ui-tab-measure = Ölç
ui-tab-solver = Çözücü
ui-tab-share = Paylaş
ui-tab-lesson = Ders

ui-unsent = Bu gönderilemiyor
    .text = Bir sayfanın gönderebileceğinden büyük: en çok 4,7 MB, yani yaklaşık 11.000 kütle.
ui-unsent-resume = Buna devam edilemiyor
ui-unsent-link = Bu açılamıyor
ui-unsent-file = Bu açılamıyor
ui-unsent-paste = Bu yapıştırılamıyor
ui-unsent-rival = Bununla yarışılamıyor
ui-all-controls = Bütün kontroller gösteriliyor
ui-no-scene = Bu adreste sahne yok
